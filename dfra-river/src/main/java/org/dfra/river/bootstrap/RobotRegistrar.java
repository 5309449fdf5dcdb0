package org.dfra.river.bootstrap;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import net.jini.admin.JoinAdmin;
import net.jini.core.entry.Entry;
import net.jini.lookup.DiscoveryAdmin;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.host.PrivateFiles;
import org.dfra.river.bootstrap.RobotBootstrap.ServiceReference;
import org.dfra.river.entry.Entries;
import org.dfra.river.entry.PersonaEntry;
import org.dfra.river.registrar.RegistrationPolicy;

/**
 * A robot's own lookup service under phoenix: stock reggie, which stores its state, listens at the
 * described port, and shows the robot's persona.
 */
final class RobotRegistrar {

  private final RobotDescription robot;
  private final String host;
  private final boolean multicast;
  private final Path state;

  /**
   * @param host address or name that its proxy carries
   * @param multicast whether it announces itself and listens for others
   * @param state phoenix's state folder
   */
  RobotRegistrar(RobotDescription robot, String host, boolean multicast, Path state) {
    this.robot = robot;
    this.host = host;
    this.multicast = multicast;
    this.state = state;
  }

  /**
   * Its activation arguments.
   *
   * @throws IOException if the folder of its state cannot be created
   * @throws org.dfra.core.config.ConfigurationException if an additional host of the robot is
   *     unknown
   */
  String[] arguments(RegistrarDescription description) throws IOException {
    Path folder = state.resolve("registrars");
    PrivateFiles.makeFolder(folder);
    return RegistrarArguments.of(
        host,
        description.port(),
        folder.resolve(robot.name()),
        robot.lookupGroups(),
        multicast,
        policy(robot, description));
  }

  /**
   * The robot that owns it, and its registration rules.
   *
   * @throws org.dfra.core.config.ConfigurationException if an additional host of the robot is
   *     unknown
   */
  static RegistrationPolicy policy(RobotDescription robot, RegistrarDescription description) {
    return new RegistrationPolicy(robot.name(), AddressRangeResolver.resolve(description));
  }

  /**
   * Starts it if it does not run, and applies the current description.
   *
   * @throws ActivationException if it cannot be activated
   * @throws IOException if its port or groups cannot be set, for example because the port is taken
   */
  void start(ServiceReference service, RegistrarDescription description, RetryDeadline patience)
      throws ActivationException, IOException {
    ServiceStart.activate(service, description.place(), patience);
    try {
      patience.run(
          () -> updateDiscovery((DiscoveryAdmin) service.id().activate(false), description));
    } catch (IOException e) {
      throw new IOException(description.place() + ": " + service.name() + ": " + e.getMessage(), e);
    }
    // Reggie's remote interface is one.
    patience.run(() -> showPersona((JoinAdmin) service.id().activate(false)));
  }

  /**
   * Reggie reads its port and groups only at its first start; later changes are set through its
   * interface.
   */
  private void updateDiscovery(DiscoveryAdmin registrar, RegistrarDescription description)
      throws IOException {
    if (description.port() != 0 && registrar.getUnicastPort() != description.port()) {
      registrar.setUnicastPort(description.port());
    }
    Set<String> groups = Set.copyOf(robot.lookupGroups());
    if (!groups.equals(Set.copyOf(Arrays.asList(registrar.getMemberGroups())))) {
      registrar.setMemberGroups(groups.toArray(String[]::new));
    }
  }

  /**
   * Attaches the robot's persona to it and replaces an older one. The registrar stores it in its
   * own log, so it is restored after every restart.
   */
  private void showPersona(JoinAdmin registrar) throws IOException {
    Entry[] old =
        Arrays.stream(registrar.getLookupAttributes())
            .filter(PersonaEntry.class::isInstance)
            .toArray(Entry[]::new);
    Entry[] wanted =
        robot.persona().map(each -> Entries.toEntries(List.of(each))).orElse(new Entry[0]);
    if (Arrays.equals(old, wanted)) {
      return;
    }
    if (old.length > 0) {
      registrar.modifyLookupAttributes(old, new Entry[old.length]); // null removes an attribute
    }
    if (wanted.length > 0) {
      registrar.addLookupAttributes(wanted);
    }
  }
}
