package org.dfra.recruit.requester;

import java.io.Serializable;
import java.time.Duration;

/**
 * An offer to help.
 *
 * @param robot that made it
 * @param number of this offer among its offers, from 0
 * @param eta time to reach the place
 * @param battery charge left, 0 to 1
 */
public record Bid(String robot, int number, Duration eta, double battery) implements Serializable {}
