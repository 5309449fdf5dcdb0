/**
 * Measured values with targets, printed and appended to a CSV file alike by the demonstrations and
 * the benchmarks. Entry point: {@link org.dfra.report.measurement.RunMeasurements}.
 */
@NullMarked
package org.dfra.report.measurement;

import org.jspecify.annotations.NullMarked;
