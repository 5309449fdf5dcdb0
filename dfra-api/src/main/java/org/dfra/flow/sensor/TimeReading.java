package org.dfra.flow.sensor;

import java.time.Duration;
import java.time.Instant;
import org.dfra.event.Reading;

/**
 * A time received from outside.
 *
 * @param utc the time that the sensor reported, UTC
 * @param hostClock the robot's own clock when the sensor's message was complete
 */
public record TimeReading(Instant utc, Instant hostClock) implements Reading {

  /**
   * How far the robot's clock is ahead of the sensor's time; + is ahead. The travel time of the
   * message is included: at 9600 baud about 0.16 s for a position frame.
   */
  public Duration hostOffset() {
    return Duration.between(utc, hostClock);
  }

  @Override
  public Instant measured() {
    return utc;
  }
}
