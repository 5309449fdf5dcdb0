/**
 * Measured figures: what each one should be, printed and appended to a CSV file alike by the
 * demonstrations and the benchmarks. Enter at {@link org.dfra.app.figure.Figures}.
 */
@NullMarked
package org.dfra.app.figure;

import org.jspecify.annotations.NullMarked;
