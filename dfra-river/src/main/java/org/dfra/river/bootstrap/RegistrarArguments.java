package org.dfra.river.bootstrap;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** What differs from one robot's registrar to another's, as arguments of its Jini configuration. */
final class RegistrarArguments {

  private RegistrarArguments() {}

  /**
   * The arguments.
   *
   * @param host address or name that its proxy carries
   * @param port TCP port of unicast discovery; 0 for one of the system's choice
   * @param folder where it keeps what it knows
   * @param groups its discovery groups
   * @param multicast whether it announces itself and listens for others
   */
  static String[] of(String host, int port, Path folder, List<String> groups, boolean multicast) {
    List<String> arguments = new ArrayList<>();
    arguments.add(RegistrarArguments.class.getResource("registrar.config").toString());
    override(arguments, "host", PhoenixProcess.quote(host));
    override(arguments, "initialUnicastDiscoveryPort", Integer.toString(port));
    override(arguments, "persistenceDirectory", PhoenixProcess.quote(folder.toString()));
    override(arguments, "initialMemberGroups", array(groups));
    if (!multicast) {
      String none = "multicastInterfaces=new java.net.NetworkInterface[]{}";
      arguments.add("com.sun.jini.reggie." + none);
      arguments.add("net.jini.discovery.LookupDiscovery." + none);
    }
    return arguments.toArray(String[]::new);
  }

  private static void override(List<String> arguments, String entry, String expression) {
    arguments.add("com.sun.jini.reggie." + entry + "=" + expression);
  }

  private static String array(List<String> texts) {
    return "new String[]{"
        + String.join(",", texts.stream().map(PhoenixProcess::quote).toList())
        + "}";
  }
}
