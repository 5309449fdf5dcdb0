package org.dfra.drivers.gps;

import java.util.List;
import org.dfra.module.Precondition;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.SensorAttributes;

/**
 * What is known of a kind of receiver before one has spoken.
 *
 * @param description what it is, for people
 * @param minRate slowest rate of positions that it can be set to, hertz
 * @param maxRate fastest rate, hertz
 * @param receiver what all receivers of the kind have in common
 * @param preconditions what its environment must be like
 */
public record GpsReceiverType(
    String description,
    double minRate,
    double maxRate,
    GpsReceiverAttributes receiver,
    List<Precondition> preconditions) {

  /** What holds for every receiver of satellites. */
  public static final Precondition SATELLITES =
      new Precondition("satellites in view of the antenna", 4, 64, "");

  public GpsReceiverType {
    preconditions = List.copyOf(preconditions);
  }

  /** A kind whose receivers tell themselves what they are, if at all. */
  public static GpsReceiverType of(
      String description, double minRate, double maxRate, List<Precondition> preconditions) {
    return new GpsReceiverType(
        description,
        minRate,
        maxRate,
        new GpsReceiverAttributes(null, null, null, null, null, List.of("2D", "3D")),
        preconditions);
  }

  SensorAttributes sensor() {
    return new SensorAttributes(
        "GpsFix",
        List.of("continuous"),
        minRate,
        maxRate,
        null,
        List.of("The antenna sees the open sky."));
  }
}
