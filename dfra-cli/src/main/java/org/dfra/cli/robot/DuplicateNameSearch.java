package org.dfra.cli.robot;

import java.io.IOException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import org.dfra.core.config.RobotDescription;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.dfra.river.bootstrap.HostAddress;
import org.dfra.river.lookup.JiniModuleDirectory;

/**
 * Searches the team for another robot of the same name while one is brought up. It runs in parallel
 * for 2 s, so that it does not delay a robot that takes longer.
 */
final class DuplicateNameSearch implements AutoCloseable {

  private static final Duration SEARCH_TIME = Duration.ofSeconds(2);

  private final String robot;
  private final String host;
  private final JiniModuleDirectory directory;
  private final long begun = System.nanoTime();

  private DuplicateNameSearch(String robot, String host, JiniModuleDirectory directory) {
    this.robot = robot;
    this.host = host;
    this.directory = directory;
  }

  /** Starts the search in the lookup services of the robot's modules. */
  static DuplicateNameSearch begin(RobotDescription robot) throws IOException {
    String host = HostAddress.resolve(robot.host());
    List<String> groups = HostAddress.isLoopback(host) ? List.of() : robot.lookupGroups();
    return new DuplicateNameSearch(
        robot.name(), host, new JiniModuleDirectory(host, groups, robot.locators()));
  }

  /**
   * The result, as a sentence without a full stop; empty if no other robot has the name.
   *
   * @param own IDs of the modules of the robot that was brought up
   */
  Optional<String> warning(Set<UUID> own) throws InterruptedException {
    Duration left = SEARCH_TIME.minusNanos(System.nanoTime() - begun);
    List<String> unused = directory.awaitFirstRead(left.isNegative() ? Duration.ZERO : left);
    return directory.find(ModuleQuery.of(Module.class).robot(robot)).stream()
        .filter(each -> !each.stale() && !own.contains(each.id()))
        .filter(this::isThere)
        .map(ModuleListing::host)
        .findFirst()
        .map(
            other ->
                "ANOTHER ROBOT IS NAMED "
                    + robot
                    + ", on "
                    + (other.equals(host) ? "this host under another phoenix" : other)
                    + ", and this one on "
                    + host
                    + "; a call to "
                    + robot
                    + " may reach either: take one of them down and give it another name in its"
                    + " XML");
  }

  /**
   * On this host a lookup service may still list modules of a previous run; these do not answer.
   */
  private boolean isThere(ModuleListing<Module> listing) {
    String other = listing.host();
    if (!other.equals(host)) {
      return !other.isEmpty();
    }
    try {
      return listing.module().readiness() != null;
    } catch (RemoteException | RuntimeException e) { // also from a foreign proxy: not alive
      return false;
    }
  }

  @Override
  public void close() {
    directory.close();
  }
}
