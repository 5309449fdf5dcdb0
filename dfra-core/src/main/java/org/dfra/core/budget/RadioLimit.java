package org.dfra.core.budget;

import java.util.function.Predicate;

/**
 * How much the network of a robot's computer carries.
 *
 * @param bytesPerSecond in both directions together, above 0
 * @param robots names of the robots that it is about
 */
public record RadioLimit(double bytesPerSecond, Predicate<String> robots) {}
