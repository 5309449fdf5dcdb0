package org.dfra.river.server;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Supplier;
import org.dfra.core.config.ConfigurationException;
import org.dfra.directory.ModuleDirectory;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.lookup.DirectorySettings;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.jspecify.annotations.Nullable;

/**
 * Supplies a module's directory of other modules, from the lookup services that the module joins.
 * Robots with the name of its own robot do not count as its own there. The directory is opened at
 * its first use; all modules of this virtual machine that join the same lookup services share it.
 */
final class ModuleDirectorySupplier implements Supplier<ModuleDirectory>, AutoCloseable {

  private static final class SharedDirectory {
    private final JiniModuleDirectory directory;
    private int users;

    SharedDirectory(JiniModuleDirectory directory) {
      this.directory = directory;
    }
  }

  /** What its users must have in common. */
  private record Shareable(DirectorySettings settings, @Nullable ChannelIdentity identity) {}

  private static final Map<Shareable, SharedDirectory> OPEN = new HashMap<>(); // guarded by itself

  private final String module;
  private final String robot;
  private final String host;
  private final OwnRobotMatcher ownModules;
  private final Shareable at;
  private final CurrentIdentity.Kept identity = CurrentIdentity.keep();

  @GuardedBy("OPEN")
  private @Nullable SharedDirectory used;

  @GuardedBy("OPEN")
  private boolean closed;

  ModuleDirectorySupplier(ModuleActivation activation) {
    this.module = activation.module().path();
    this.robot = activation.module().robot();
    this.host = activation.host();
    this.ownModules = new OwnRobotMatcher(activation);
    this.at =
        new Shareable(
            DirectorySettings.of(
                activation.host(), activation.lookupGroups(), activation.locators()),
            CurrentIdentity.get());
  }

  /**
   * The directory.
   *
   * @throws ConfigurationException if multicast cannot be used or a locator is malformed
   */
  @Override
  public ModuleDirectory get() {
    synchronized (OPEN) {
      SharedDirectory shared = used;
      if (shared != null) {
        return own(shared);
      }
      if (closed) {
        throw new IllegalStateException(module + " has ended and looks for no other modules");
      }
      shared = OPEN.get(at);
      if (shared == null) {
        shared = new SharedDirectory(open());
        OPEN.put(at, shared);
      }
      shared.users++;
      used = shared;
      return own(shared);
    }
  }

  private ModuleDirectory own(SharedDirectory shared) {
    return new OwnRobotDirectory(shared.directory, robot, host, ownModules);
  }

  private JiniModuleDirectory open() {
    try {
      return identity.call(() -> new JiniModuleDirectory(at.settings(), InstantSource.system()));
    } catch (IOException e) {
      throw new ConfigurationException(
          module
              + " cannot look for other modules ("
              + e.getMessage()
              + "); correct groups and locators in <lookup> of the robot's XML",
          e);
    }
  }

  /** Closes the module's use of the directory; the last user closes the directory. */
  @Override
  public void close() {
    @Nullable JiniModuleDirectory ending = null;
    synchronized (OPEN) {
      closed = true;
      SharedDirectory shared = used;
      used = null;
      if (shared != null && --shared.users == 0) {
        OPEN.remove(at);
        ending = shared.directory;
      }
    }
    if (ending != null) {
      ending.close();
    }
  }
}
