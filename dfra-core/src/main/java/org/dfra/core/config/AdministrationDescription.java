package org.dfra.core.config;

import java.util.List;

/**
 * The hosts that may administer a robot besides its own computer.
 *
 * @param administratorHosts addresses, ranges as {@code 10.0.0.0/24}, and host names, which are not
 *     resolved here; empty for the robot's own computer only
 * @param place its place in the configuration
 */
public record AdministrationDescription(List<String> administratorHosts, Place place) {

  /** The robot's own computer only. */
  public static final AdministrationDescription LOCAL =
      new AdministrationDescription(List.of(), Place.CODE);

  public AdministrationDescription {
    administratorHosts = List.copyOf(administratorHosts);
    for (String each : administratorHosts) {
      DescriptionRules.require(place, DescriptionRules.administrator(each));
    }
  }
}
