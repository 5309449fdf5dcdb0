package org.dfra.core.config;

import java.util.List;

/**
 * From where a robot may be administered besides its own computer.
 *
 * @param from addresses, ranges as {@code 10.0.0.0/24}, and host names, which are not resolved
 *     here; empty for the robot's own computer only
 * @param place where it was written
 */
public record AdministrationDescription(List<String> from, Place place) {

  /** The robot's own computer only. */
  public static final AdministrationDescription LOCAL =
      new AdministrationDescription(List.of(), Place.CODE);

  public AdministrationDescription {
    from = List.copyOf(from);
    for (String each : from) {
      Rules.require(place, Rules.administrator(each));
    }
  }
}
