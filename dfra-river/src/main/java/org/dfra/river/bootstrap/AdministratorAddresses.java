package org.dfra.river.bootstrap;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;
import org.dfra.core.config.AdministrationDescription;
import org.dfra.core.config.ConfigurationException;
import org.dfra.river.access.AddressRange;

/** The addresses from which a robot may be administered, its host names resolved. */
final class AdministratorAddresses {

  private AdministratorAddresses() {}

  /**
   * Resolves what a robot's XML says. A name stands for all addresses that it has now: the robot's
   * processes do not look it up again.
   *
   * @throws ConfigurationException if a name has no address
   */
  static List<AddressRange> resolve(AdministrationDescription administration) {
    List<AddressRange> ranges = new ArrayList<>();
    for (String each : administration.from()) {
      if (isNumeric(each)) {
        ranges.add(AddressRange.of(each));
      } else {
        for (InetAddress address : lookUp(each, administration)) {
          ranges.add(AddressRange.only(address));
        }
      }
    }
    return List.copyOf(ranges);
  }

  /** A name has neither, as the description has checked; and one of digits only is an address. */
  private static boolean isNumeric(String text) {
    return text.indexOf(':') >= 0 || text.indexOf('/') >= 0 || text.matches("[0-9.]+");
  }

  private static InetAddress[] lookUp(String name, AdministrationDescription administration) {
    try {
      return InetAddress.getAllByName(name);
    } catch (UnknownHostException e) {
      throw new ConfigurationException(
          administration.place()
              + ": the administrator's host "
              + name
              + " is not known; write its address, or mend the name in"
              + " <administration from=\"…\">",
          e);
    }
  }
}
