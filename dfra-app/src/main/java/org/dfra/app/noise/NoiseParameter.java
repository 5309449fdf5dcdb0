package org.dfra.app.noise;

/**
 * A figure that was measured.
 *
 * @param name of the parameter that it is for, as estimators call it
 * @param value NaN where too little was heard
 * @param unit its unit; may be empty
 * @param basis what it was made of, in words
 */
public record NoiseParameter(String name, double value, String unit, String basis) {}
