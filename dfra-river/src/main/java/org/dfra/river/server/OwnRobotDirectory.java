package org.dfra.river.server;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.dfra.directory.Condition;
import org.dfra.directory.DirectoryListener;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.directory.Persona;
import org.dfra.module.Module;
import org.dfra.persona.ModuleAttributes;

/**
 * The directory that a module uses. A query for modules of its own robot returns only modules on
 * its own host that belong to the robot. Another robot of the same name in the team, or on this
 * computer, is a different robot: its wheels must not be moved and its position must not be used.
 */
final class OwnRobotDirectory implements ModuleDirectory {

  private final ModuleDirectory all;
  private final String robot;
  private final String host;
  private final Predicate<ModuleListing<?>> isOwn;

  /**
   * @param all the directory of all robots; closed with this
   * @param robot the module's own robot
   * @param host address or name of this computer, as in {@link ModuleAttributes#host}
   * @param isOwn whether a module of that name and host is the robot's own
   */
  public OwnRobotDirectory(
      ModuleDirectory all, String robot, String host, Predicate<ModuleListing<?>> isOwn) {
    this.all = all;
    this.robot = robot;
    this.host = host;
    this.isOwn = isOwn;
  }

  private <M extends Module> ModuleQuery<M> own(ModuleQuery<M> query) {
    return query.robot().filter(robot::equals).isPresent()
        ? query.where(ModuleAttributes.class, "host", Condition.equalTo(host)).where(isOwn)
        : query;
  }

  @Override
  public <M extends Module> List<ModuleListing<M>> find(ModuleQuery<M> query) {
    return all.find(own(query));
  }

  @Override
  public <M extends Module> Optional<ModuleListing<M>> findFirst(
      ModuleQuery<M> query, Duration patience) throws InterruptedException {
    return all.findFirst(own(query), patience);
  }

  @Override
  public <M extends Module> DirectoryRegistration listen(
      ModuleQuery<M> query, DirectoryListener<M> listener) {
    return all.listen(own(query), listener);
  }

  @Override
  public List<Persona> personas() {
    return all.personas();
  }

  @Override
  public <M extends Module> M proxyFor(ModuleQuery<M> query) {
    return all.proxyFor(own(query));
  }

  @Override
  public void close() {
    all.close();
  }
}
