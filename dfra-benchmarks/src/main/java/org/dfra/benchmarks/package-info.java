/**
 * The benchmarks: each measures quantities for which the requirements state a target, prints them
 * beside the target, and optionally appends them to a CSV file. Entry point: {@link
 * org.dfra.benchmarks.BenchCommand}.
 */
@NullMarked
package org.dfra.benchmarks;

import org.jspecify.annotations.NullMarked;
