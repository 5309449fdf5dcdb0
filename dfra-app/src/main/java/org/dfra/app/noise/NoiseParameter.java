package org.dfra.app.noise;

/**
 * A measured noise parameter.
 *
 * @param name of the parameter, as in the estimators
 * @param value NaN if there were too few readings
 * @param unit its unit; may be empty
 * @param basis the data that it is based on, in words
 */
public record NoiseParameter(String name, double value, String unit, String basis) {}
