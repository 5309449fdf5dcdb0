package org.dfra.river.bootstrap;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.river.registrar.RegistrationPolicy;

/** The arguments of a registrar's Jini configuration, which differ from robot to robot. */
final class RegistrarArguments {

  private static final String HOST = "com.sun.jini.reggie.host=";
  private static final String PORT = "com.sun.jini.reggie.initialUnicastDiscoveryPort=";
  private static final String GROUPS = "com.sun.jini.reggie.initialMemberGroups=";

  private static final String CONFIGURATION = "registrar.config";

  private RegistrarArguments() {}

  /**
   * The arguments.
   *
   * @param host address or name that its proxy carries
   * @param port TCP port of unicast discovery; 0 for one that the system chooses
   * @param folder of its persistent state
   * @param groups its discovery groups
   * @param multicast whether it announces itself and listens for others
   * @param policy the robot that owns it, and its registration rules
   */
  static String[] of(
      String host,
      int port,
      Path folder,
      List<String> groups,
      boolean multicast,
      RegistrationPolicy policy) {
    List<String> arguments = new ArrayList<>();
    arguments.add(RegistrarArguments.class.getResource(CONFIGURATION).toString());
    arguments.add(HOST + PhoenixProcess.quote(host));
    arguments.add(PORT + port);
    arguments.add(
        "com.sun.jini.reggie.persistenceDirectory=" + PhoenixProcess.quote(folder.toString()));
    arguments.add(GROUPS + array(groups));
    arguments.add("com.sun.jini.reggie.robot=" + PhoenixProcess.quote(policy.robot()));
    arguments.add(
        "com.sun.jini.reggie.moduleHosts=" + PhoenixProcess.quote(policy.robotHostsText()));
    if (!multicast) {
      String none = "multicastInterfaces=new java.net.NetworkInterface[]{}";
      arguments.add("com.sun.jini.reggie." + none);
      arguments.add("net.jini.discovery.LookupDiscovery." + none);
    }
    return arguments.toArray(String[]::new);
  }

  /** The TCP port in such arguments; 0 for one that the system chooses, or if there is none. */
  static int port(List<String> arguments) {
    return value(arguments, PORT).map(Integer::parseInt).orElse(0);
  }

  /** The host in such arguments. */
  static Optional<String> host(List<String> arguments) {
    return value(arguments, HOST).map(quoted -> quoted.substring(1, quoted.length() - 1));
  }

  private static Optional<String> value(List<String> arguments, String entry) {
    return arguments.stream()
        .filter(each -> each.startsWith(entry))
        .map(each -> each.substring(entry.length()))
        .findFirst();
  }

  /**
   * The arguments that apply only at start; the others can be changed while the registrar runs. The
   * path of its configuration is excluded: it differs from build to build, but the contents are the
   * same.
   */
  static List<String> startupOnly(List<String> arguments) {
    return arguments.stream()
        .filter(
            each ->
                !each.startsWith(PORT)
                    && !each.startsWith(GROUPS)
                    && !each.endsWith("/" + CONFIGURATION))
        .toList();
  }

  private static String array(List<String> texts) {
    return "new String[]{"
        + String.join(",", texts.stream().map(PhoenixProcess::quote).toList())
        + "}";
  }
}
