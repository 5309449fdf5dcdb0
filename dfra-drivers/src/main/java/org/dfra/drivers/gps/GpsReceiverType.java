package org.dfra.drivers.gps;

import java.util.List;
import org.dfra.module.Precondition;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.SensorAttributes;

/**
 * What is known of a type of receiver before it has sent data.
 *
 * @param description human-readable description
 * @param minRate minimum configurable rate of positions, hertz
 * @param maxRate maximum rate, hertz
 * @param receiver attributes that all receivers of the type share
 * @param preconditions environmental preconditions
 */
public record GpsReceiverType(
    String description,
    double minRate,
    double maxRate,
    GpsReceiverAttributes receiver,
    List<Precondition> preconditions) {

  /** The precondition of every satellite receiver. */
  public static final Precondition SATELLITES =
      new Precondition("satellites in view of the antenna", 4, 64, "");

  public GpsReceiverType {
    preconditions = List.copyOf(preconditions);
  }

  /** A type whose receivers identify themselves, if at all. */
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
