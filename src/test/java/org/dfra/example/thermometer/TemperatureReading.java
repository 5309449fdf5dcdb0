package org.dfra.example.thermometer;

import java.time.Instant;
import org.dfra.event.Reading;

/**
 * How warm it was.
 *
 * @param celsius degrees Celsius
 * @param measured when
 */
public record TemperatureReading(double celsius, Instant measured) implements Reading {}
