/**
 * The benchmarks: each measures what the requirements put a figure on, prints it beside what is
 * wanted, and appends it to a CSV file if asked to. Enter at {@link
 * org.dfra.app.benchmark.BenchCommand}.
 */
@NullMarked
package org.dfra.app.benchmark;

import org.jspecify.annotations.NullMarked;
