package org.dfra.river.server;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import java.util.function.Predicate;
import org.dfra.core.host.CommandName;
import org.dfra.directory.ModuleListing;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Determines which modules of a computer belong to a module's own robot: those whose identities
 * this robot stores, each in the module's folder. Another robot of the same name on this computer
 * stores its own elsewhere, with another phoenix. Thread-safe.
 *
 * <p>An identity that cannot be read proves nothing, so its module counts as another robot's. The
 * file is read again after at least a second, when the directory checks the module again.
 */
final class OwnRobotMatcher implements Predicate<ModuleListing<?>> {

  private static final Logger LOG = LoggerFactory.getLogger(OwnRobotMatcher.class);

  private static final long AGAIN_NANOS = TimeUnit.SECONDS.toNanos(1);
  private static final int MOST = 1000;

  /** Of the robot's modules; null if they store nothing, so that none can be identified. */
  private final @Nullable Path folder;

  private final Map<String, UUID> known = new ConcurrentHashMap<>(); // by module's name
  private final Map<UUID, Long> refused = new ConcurrentHashMap<>(); // when, by service ID
  private final Set<String> warned = ConcurrentHashMap.newKeySet();
  private final LongSupplier nanos;

  OwnRobotMatcher(ModuleActivation activation) {
    this(activation, System::nanoTime);
  }

  /** For tests, with another clock. */
  OwnRobotMatcher(ModuleActivation activation, LongSupplier nanos) {
    this.nanos = nanos;
    @Nullable String own = activation.state();
    this.folder = own == null ? null : Path.of(own).toAbsolutePath().getParent();
  }

  @Override
  public boolean test(ModuleListing<?> listing) {
    if (folder == null || listing.id().equals(known.get(listing.name()))) {
      return true;
    }
    @Nullable Long before = refused.get(listing.id());
    if (before != null && nanos.getAsLong() - before < AGAIN_NANOS) {
      return false; // the directory asks repeatedly about another robot's
    }
    Optional<UUID> kept = kept(folder, listing.name());
    kept.ifPresent(id -> known.put(listing.name(), id));
    boolean isOwn = kept.filter(listing.id()::equals).isPresent();
    if (!isOwn) {
      refuse(listing.id());
    }
    return isOwn;
  }

  private void refuse(UUID id) {
    if (refused.size() >= MOST) { // the network may supply any number
      refused.clear();
    }
    refused.put(id, nanos.getAsLong());
  }

  private Optional<UUID> kept(Path folder, String module) {
    try {
      Path own = folder.resolve(module);
      return folder.equals(own.getParent()) // a name from the network may be any text
          ? ModuleIdentity.read(own).map(ModuleIdentity::id)
          : Optional.empty();
    } catch (InvalidPathException e) {
      return Optional.empty();
    } catch (IOException e) {
      if (warned.add(module + e)) {
        LOG.warn(
            "The identity of module {} in {} cannot be read ({}), so it counts as another robot's;"
                + " bring the robot up again: {} up ROBOT.XML",
            module,
            folder,
            e.toString(),
            CommandName.current());
      }
      return Optional.empty();
    }
  }
}
