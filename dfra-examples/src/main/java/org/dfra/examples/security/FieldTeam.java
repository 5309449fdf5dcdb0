package org.dfra.examples.security;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.security.GeneralSecurityException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.module.Module;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.river.security.SecureProcess;

/**
 * The members of a team, and how each of them calls robots from this process. The process itself
 * has anna's identity.
 */
final class FieldTeam {

  /** Operator, on the computer of the authority. */
  static final String ANNA = "anna";

  /** Another operator. */
  static final String OSCAR = "oscar";

  /** Observer. */
  static final String OTTO = "otto";

  /** A robot of the team that somebody has taken over. */
  static final String MALLORY = "mallory";

  /** The robots that search. */
  static final List<String> ROBOTS = List.of("atrv1", "atrv2");

  /** Variable with the lookup services that are asked. */
  static final String LOCATORS = "DFRA_LOCATORS";

  private static final int MOST_SERVICES = 256;

  private final DemoEnvironment environment;
  private final MemberCommands commands;
  private final Map<String, Integer> registrars;
  private final Map<String, Integer> phoenixes;
  private final String robotLocators;
  private final Map<String, ChannelIdentity> identities = new ConcurrentHashMap<>();
  private final List<String> up = new CopyOnWriteArrayList<>();

  /**
   * @param registrars ports of the robots' lookup services
   * @param phoenixes ports of their activation daemons
   * @param robotLocators the lookup services that robots ask, separated by commas
   */
  FieldTeam(
      DemoEnvironment environment,
      MemberCommands commands,
      Map<String, Integer> registrars,
      Map<String, Integer> phoenixes,
      String robotLocators) {
    this.environment = environment;
    this.commands = commands;
    this.registrars = Map.copyOf(registrars);
    this.phoenixes = Map.copyOf(phoenixes);
    this.robotLocators = robotLocators;
  }

  /** Calls in the name of a member: what is received and exported meanwhile keeps its identity. */
  <T, E extends Exception> T as(String member, CurrentIdentity.Body<T, E> body)
      throws E, IOException {
    return CurrentIdentity.callAs(identity(member), body);
  }

  private ChannelIdentity identity(String member) throws IOException {
    ChannelIdentity known = identities.get(member);
    if (known == null) {
      try {
        known = SecureProcess.other(commands.security(member));
      } catch (IdentityException | GeneralSecurityException e) {
        throw new IOException("the identity of " + member + " cannot be used: " + e, e);
      }
      identities.put(member, known);
    }
    return known;
  }

  /** The lookup service of a robot, as the caller of this thread receives it. */
  ServiceRegistrar registrar(String robot) throws IOException {
    try {
      return new LookupLocator(DemoEnvironment.ADDRESS, port(robot)).getRegistrar();
    } catch (ClassNotFoundException e) {
      throw new IOException("the lookup service of " + robot + " has an unknown class", e);
    }
  }

  private int port(String robot) {
    Integer port = registrars.get(robot);
    if (port == null) {
      throw new IllegalArgumentException("there is no robot " + robot);
    }
    return port;
  }

  /** The services of a robot's lookup service, as the caller of this thread sees them. */
  List<ServiceItem> services(String robot) throws IOException {
    ServiceTemplate any = new ServiceTemplate(null, null, null);
    return List.of(registrar(robot).lookup(any, MOST_SERVICES).items);
  }

  /** A module, {@code robot/name}, as the caller of this thread receives it. */
  <M extends Module> M find(Class<M> kind, String path) throws Exception {
    String robot = path.substring(0, path.indexOf('/'));
    List<M> found = new ArrayList<>();
    DemoAssertions.await(
        "that " + path + " is found",
        DemoEnvironment.PATIENCE,
        () -> {
          look(kind, robot, path).ifPresent(found::add);
          return !found.isEmpty();
        });
    return found.get(0);
  }

  private <M extends Module> Optional<M> look(Class<M> kind, String robot, String path)
      throws IOException {
    for (ServiceItem item : services(robot)) {
      if (kind.isInstance(item.service)
          && kind.cast(item.service).identification().path().equals(path)) {
        return Optional.of(kind.cast(item.service));
      }
    }
    return Optional.empty();
  }

  /** Types {@code up} for a robot on its computer; its processes end with the environment. */
  List<String> bringUp(String robot) throws IOException, InterruptedException {
    List<String> lines = commands.run(robot, Map.of(LOCATORS, robotLocators), upWords(robot));
    up.add(robot);
    rememberProcesses(robot);
    return lines;
  }

  /** The words of the command that brings a robot up. */
  String[] upWords(String robot) {
    return new String[] {
      "up",
      Path.of(System.getProperty("dfra.root", ""), "config", "teams", "raster", robot + ".xml")
          .toAbsolutePath()
          .toString(),
      "--port=" + phoenixes.get(robot)
    };
  }

  private void rememberProcesses(String robot) throws IOException {
    PhoenixProcess phoenix =
        new PhoenixProcess(
            DemoEnvironment.ADDRESS,
            Optional.ofNullable(phoenixes.get(robot)).orElseThrow(),
            -1,
            commands.state(robot));
    List<Long> processes = new ArrayList<>();
    phoenix.pid().ifPresent(processes::add);
    try {
      as(robot, () -> phoenix.admin().groupStatus()).stream()
          .map(GroupStatus::pid)
          .forEach(processes::add);
    } catch (RemoteException e) {
      throw new IOException("the phoenix of " + robot + " does not answer", e);
    }
    processes.stream()
        .filter(pid -> pid > 0)
        .flatMap(pid -> ProcessHandle.of(pid).stream())
        .forEach(environment::remember);
  }

  /** Types {@code down} for each robot that is up. */
  void takeDown() throws IOException, InterruptedException {
    for (String robot : up) {
      rememberProcesses(robot); // also those that were restarted
      List<String> unused = commands.run(robot, "down");
    }
    up.clear();
  }
}
