package org.dfra.river.bootstrap;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.core.config.RobotDescription.AdministrationDescription;
import org.dfra.core.config.SourceLocation;
import org.dfra.river.access.AddressRange;

/** Resolves the addresses and host names in a robot's XML. */
final class AddressRangeResolver {

  private AddressRangeResolver() {}

  /**
   * Resolves the addresses that may administer a robot. A name stands for all addresses that it has
   * now: the robot's processes do not look it up again.
   *
   * @throws ConfigurationException if a name has no address
   */
  static List<AddressRange> resolve(AdministrationDescription administration) {
    return resolve(
        administration.administratorHosts(),
        administration.place(),
        "the administrator's host",
        "<administration from=\"…\">");
  }

  /**
   * Resolves the additional hosts on which modules of the robot run. A name stands for all
   * addresses that it has now.
   *
   * @throws ConfigurationException if a name has no address
   */
  static List<AddressRange> resolve(RegistrarDescription registrar) {
    return resolve(
        registrar.moduleHosts(),
        registrar.place(),
        "the registrar's module host",
        "<registrar module-hosts=\"…\">");
  }

  private static List<AddressRange> resolve(
      List<String> from, SourceLocation place, String what, String where) {
    List<AddressRange> ranges = new ArrayList<>();
    for (String each : from) {
      if (isNumeric(each)) {
        ranges.add(AddressRange.of(each));
      } else {
        for (InetAddress address : lookUp(each, place, what, where)) {
          ranges.add(AddressRange.only(address));
        }
      }
    }
    return List.copyOf(ranges);
  }

  /**
   * A name is neither an address nor a range; the description has checked that. A text of digits
   * only is an address.
   */
  private static boolean isNumeric(String text) {
    return text.indexOf(':') >= 0 || text.indexOf('/') >= 0 || text.matches("[0-9.]+");
  }

  private static InetAddress[] lookUp(
      String name, SourceLocation place, String what, String where) {
    try {
      return InetAddress.getAllByName(name);
    } catch (UnknownHostException e) {
      throw new ConfigurationException(
          place
              + ": "
              + what
              + " "
              + name
              + " is not known; write its address, or correct the name in "
              + where,
          e);
    }
  }
}
