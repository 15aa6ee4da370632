#!/usr/bin/env python3
"""Fails where a source of lib or apps uses a name of the standard library whose header is included neither by it nor by a header of
ours that it includes. Compilers do not see that: headers of the standard library include each other, in each library others.

usage: standard_headers.py ROOT
"""
import functools
import pathlib
import re
import sys

# The names that are used of each header.
NAMES = {
    'algorithm': '''adjacent_find all_of any_of binary_search clamp copy copy_if copy_n count count_if equal
        equal_range fill find find_first_of find_if find_if_not for_each inplace_merge is_permutation
        is_sorted iter_swap lexicographical_compare lower_bound max max_element merge min min_element minmax
        minmax_element next_permutation none_of nth_element partition_point ranges remove_if replace reverse
        rotate set_difference set_intersection set_symmetric_difference set_union sort stable_partition
        stable_sort transform unique upper_bound''',
    'array': 'array',
    'atomic': 'atomic atomic_ref memory_order_acquire memory_order_relaxed memory_order_release',
    'bit': 'bit_cast bit_ceil bit_width countl_zero countr_zero endian popcount',
    'bitset': 'bitset',
    'cctype': 'tolower toupper',
    'charconv': 'chars_format from_chars to_chars',
    'chrono': 'chrono',
    'cmath': '''acos asin atan2 ceil copysign cos floor fma frexp hypot ilogb isfinite isinf isnan isnormal
        ldexp log2 lround nextafter pow round signbit sqrt''',
    'concepts': 'integral predicate same_as',
    'condition_variable': 'condition_variable',
    'csignal': 'sig_atomic_t',
    'cstddef': 'byte max_align_t ptrdiff_t size_t',
    'cstdint': 'int16_t int32_t int64_t int8_t uint16_t uint32_t uint64_t uint8_t',
    'cstdio': 'snprintf',
    'cstdlib': 'free getenv',
    'cstring': 'memchr memcpy',
    'deque': 'deque',
    'exception': 'current_exception exception exception_ptr rethrow_exception',
    'filesystem': 'filesystem',
    'fstream': 'ifstream',
    'functional': 'bind_front function greater greater_equal identity invoke less not_fn plus',
    'initializer_list': 'initializer_list',
    'iostream': 'cerr cout',
    'iterator': 'back_inserter forward_iterator_tag input_iterator_tag make_move_iterator ssize',
    'limits': 'numeric_limits',
    'list': 'list',
    'map': 'map',
    'memory': 'make_shared make_unique make_unique_for_overwrite shared_ptr weak_ptr unique_ptr',
    'mutex': 'call_once lock_guard mutex once_flag unique_lock',
    'new': 'align_val_t bad_alloc nothrow_t',
    'numbers': 'numbers',
    'numeric': 'accumulate exclusive_scan iota midpoint partial_sum',
    'optional': 'nullopt optional',
    'queue': 'priority_queue',
    'set': 'set',
    'span': 'span',
    'sstream': 'istringstream',
    'stdexcept': 'out_of_range runtime_error',
    'string': 'getline string to_string',
    'string_view': 'string_view',
    'system_error': 'errc error_code system_category',
    'tuple': 'apply tie tuple tuple_cat',
    'type_traits': 'decay_t invoke_result_t is_same_v remove_const_t remove_reference_t',
    'unordered_map': 'unordered_map',
    'unordered_set': 'unordered_set',
    'utility': 'as_const exchange in_place in_range move pair swap',
    'variant': 'get_if holds_alternative variant',
    'vector': 'vector',
}
# Names that several headers declare, or that are used only of types that a header declares; any of these will do.
OF_SEVERAL = {
    'abs': {'cmath', 'cstdlib'},
    'endl': {'iostream', 'ostream'},
    'erase': {'string', 'vector'},
    'erase_if': {'map', 'set', 'string', 'unordered_map', 'unordered_set', 'vector'},
    'flush': {'iostream', 'ostream'},
    'get': {'array', 'tuple', 'utility', 'variant'},
    'ios': {'fstream', 'ios', 'iostream'},
    'ostream': {'fstream', 'iosfwd', 'iostream', 'ostream', 'sstream'},
    'streamoff': {'fstream', 'ios', 'iostream'},
    'tuple_size_v': {'array', 'tuple', 'utility'},
}
HEADERS_OF = {name: {header} for header, names in NAMES.items() for name in names.split()} | OF_SEVERAL


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    folders = [root / 'lib', *(root / 'apps' / name for name in ('common', 'meshalyzer', 'meshfixer'))]
    files = [path for folder in ('lib', 'apps') for path in sorted((root / folder).rglob('*')) if path.suffix in ('.h', '.cpp')]

    @functools.cache
    def included_by(path):
        """Returns the standard headers and those of ours that a file includes."""
        text = path.read_text()
        ours = set()
        for name in re.findall(r'^#include "(.*)"$', text, re.MULTILINE):
            found = [folder / name for folder in (path.parent, *folders) if (folder / name).exists()]
            if not found:
                sys.exit(f'{path}: cannot find {name}')
            ours.add(found[0])
        return set(re.findall(r'^#include <(\w+)>$', text, re.MULTILINE)), ours

    def standard_headers(path):
        """Returns the standard headers that a file includes, itself or by headers of ours."""
        seen, left, standard = {path}, [path], set()
        while left:
            of_standard, ours = included_by(left.pop())
            standard |= of_standard
            left += ours - seen
            seen |= ours
        return standard

    faults = []
    for path in files:
        code = re.sub(r'//.*', '', path.read_text())
        included = standard_headers(path)
        for name in sorted(set(re.findall(r'\bstd::(\w+)', code))):
            if name not in HEADERS_OF:
                faults.append(f'{path.relative_to(root)}: the header of std::{name} is not in {pathlib.Path(__file__).name}')
            elif not HEADERS_OF[name] & included:
                faults.append(f'{path.relative_to(root)}: std::{name} without <{"> or <".join(sorted(HEADERS_OF[name]))}>')
    if faults:
        sys.exit('\n'.join(faults))
    print(f'{len(files)} files include the standard headers that they use')


if __name__ == '__main__':
    main()
