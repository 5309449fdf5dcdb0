package org.dfra.river.server;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import org.dfra.directory.ModuleListing;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Which modules of a computer are of a module's own robot: those whose identities this robot keeps,
 * each in the module's folder. Another robot of the same name on this computer keeps its own
 * elsewhere, with another phoenix. Safe for use by several threads.
 */
final class OwnModules implements Predicate<ModuleListing<?>> {

  private static final Logger LOG = LoggerFactory.getLogger(OwnModules.class);

  /** Of the robot's modules; null where they keep nothing, and none can be told from another's. */
  private final @Nullable Path folder;

  private final Map<String, UUID> known = new ConcurrentHashMap<>();

  OwnModules(ModuleActivation activation) {
    @Nullable String own = activation.state();
    this.folder = own == null ? null : Path.of(own).toAbsolutePath().getParent();
  }

  @Override
  public boolean test(ModuleListing<?> listing) {
    if (folder == null || listing.id().equals(known.get(listing.name()))) {
      return true;
    }
    // Not known yet, or not of this robot; rare enough to be read each time.
    Optional<UUID> kept = kept(folder, listing.name());
    kept.ifPresent(id -> known.put(listing.name(), id));
    return kept.filter(listing.id()::equals).isPresent();
  }

  private static Optional<UUID> kept(Path folder, String module) {
    try {
      Path own = folder.resolve(module);
      return folder.equals(own.getParent()) // a name from the network may be anything
          ? ModuleIdentity.read(own).map(ModuleIdentity::id)
          : Optional.empty();
    } catch (InvalidPathException e) {
      return Optional.empty();
    } catch (IOException e) {
      LOG.warn(
          "The identity of module {} in {} cannot be read ({}), so it counts as another robot's;"
              + " bring the robot up again: ./dfra up ROBOT.XML",
          module,
          folder,
          e.toString());
      return Optional.empty();
    }
  }
}
