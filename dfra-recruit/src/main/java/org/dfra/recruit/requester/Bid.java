package org.dfra.recruit.requester;

import java.io.Serializable;
import java.time.Duration;

/**
 * An offer to come.
 *
 * @param robot who made it
 * @param number which of its offers, from 0
 * @param eta how long it takes to be there
 * @param battery charge left, 0 to 1
 */
public record Bid(String robot, int number, Duration eta, double battery) implements Serializable {}
