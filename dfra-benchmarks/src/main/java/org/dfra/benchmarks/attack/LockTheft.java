package org.dfra.benchmarks.attack;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.river.phoenix.PhoenixIdentities;

/**
 * Takes the locks of phoenix's private files, as another user of the robot's computer: a group
 * whose lock is held cannot be restarted. A lock on a file of its own proves that it can take locks
 * at all.
 */
public final class LockTheft extends AttackTask {

  private static final long AGAIN_MILLIS = 20;

  private final FileLocks locks = new FileLocks();
  private List<Path> wanted = List.of();

  /** Called by {@code TaskMain} by reflection. */
  public LockTheft() {}

  @Override
  protected void prepare(Target target) throws IOException {
    Path unused = take(Files.createFile(target.folder().resolve("own.lock")));
    Path ofGroup = target.groupLock();
    wanted =
        List.of(
            ofGroup,
            ofGroup.resolveSibling("phoenix.lock"),
            ofGroup.resolveSibling(PhoenixIdentities.FILE));
  }

  @Override
  protected void attack(Target target) {
    for (Path each : wanted) {
      var unused = attempt(() -> take(each));
    }
    pause(AGAIN_MILLIS);
  }

  private Path take(Path file) throws IOException {
    if (!locks.take(file)) {
      throw new IOException("another process holds the lock of " + file);
    }
    return file;
  }

  @Override
  protected List<MeasuredValue> figures() {
    return List.of(new MeasuredValue("locks held by the attacker", locks.count() - 1, 0, ""));
  }
}
