/**
 * The benchmarks: each measures quantities for which the requirements state a target, prints them
 * beside the target, and optionally appends them to a CSV file. Entry point: {@link
 * org.dfra.app.benchmark.BenchCommand}.
 */
@NullMarked
package org.dfra.app.benchmark;

import org.jspecify.annotations.NullMarked;
