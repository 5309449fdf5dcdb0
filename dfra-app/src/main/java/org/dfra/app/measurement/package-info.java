/**
 * Measured figures: what each one should be, printed and appended to a CSV file alike by the
 * demonstrations and the benchmarks. Enter at {@link org.dfra.app.measurement.RunMeasurements}.
 */
@NullMarked
package org.dfra.app.measurement;

import org.jspecify.annotations.NullMarked;
