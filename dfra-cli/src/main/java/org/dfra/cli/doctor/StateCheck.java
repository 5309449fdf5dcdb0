package org.dfra.cli.doctor;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToLongFunction;
import java.util.stream.Stream;
import org.dfra.cli.doctor.CheckRunner.Check;
import org.dfra.core.host.CommandName;
import org.dfra.core.host.PrivateFiles;
import org.jspecify.annotations.Nullable;

/** Checks phoenix's state folder: whether it is writable, its free space, its journal. */
final class StateCheck implements Check {

  private static final long KILOBYTE = 1 << 10;
  private static final long MEGABYTE = 1 << 20;
  private static final long GIGABYTE = 1 << 30;

  /** Below this, the next few group logs, 10 MB each, would fill the disk. */
  private static final long LOW_SPACE = 100 * MEGABYTE;

  private static final long NO_SPACE = 5 * MEGABYTE;

  /** The registrations of a thousand modules take some megabytes. */
  private static final long LARGE_JOURNAL = 100 * MEGABYTE;

  private final Path state;
  private final ToLongFunction<Path> freeBytes;

  /**
   * @param state the folder; it may not exist yet
   * @param freeBytes returns the free space at a path, in bytes
   */
  StateCheck(Path state, ToLongFunction<Path> freeBytes) {
    this.state = state;
    this.freeBytes = freeBytes;
  }

  /** The folder on this computer's disk. */
  static StateCheck of(Path state) {
    return new StateCheck(state, path -> path.toFile().getUsableSpace());
  }

  @Override
  public Subject subject() {
    return Subject.STATE_FOLDER;
  }

  @Override
  public List<Finding> run() {
    List<Finding> findings = new ArrayList<>();
    Path existing = existing(state);
    findings.add(folder(existing));
    findings.add(space(existing));
    Path journal = state.resolve("journal");
    if (Files.isDirectory(journal)) {
      findings.add(journal(journal));
    }
    return findings;
  }

  /** The folder itself, or its nearest existing parent. */
  private static Path existing(Path path) {
    for (Path each = path; each != null; each = each.getParent()) {
      if (Files.exists(each)) {
        return each;
      }
    }
    return path;
  }

  private Finding folder(Path existing) {
    if (Files.isDirectory(existing) && Files.isWritable(existing)) {
      @Nullable String fault = existing.equals(state) ? permissionFault(state) : null;
      if (fault != null) {
        return Finding.fail(
            subject(),
            fault,
            "Until then no phoenix starts with it; "
                + CommandName.current()
                + " down ends one that runs.");
      }
      return Finding.ok(
          subject(),
          existing.equals(state)
              ? state + " can be written"
              : state + " is not there yet and can be made");
    }
    return Finding.fail(
        subject(),
        Files.isDirectory(existing)
            ? existing + " cannot be written by this user"
            : existing + " is not a folder",
        "Correct its permissions, or name another folder with --state or in DFRA_STATE.");
  }

  private static @Nullable String permissionFault(Path folder) {
    try {
      return PrivateFiles.privacyFault(folder);
    } catch (IOException e) {
      return e.getMessage();
    }
  }

  private Finding space(Path existing) {
    long left = freeBytes.applyAsLong(existing);
    String what = "there is room for " + size(left) + " in " + state;
    if (left >= LOW_SPACE) {
      return Finding.ok(Subject.DISK_SPACE, what);
    }
    String remedy =
        "Free space there, or name a folder on another disk with --state or in DFRA_STATE.";
    return left >= NO_SPACE
        ? Finding.warn(Subject.DISK_SPACE, what, remedy)
        : Finding.fail(Subject.DISK_SPACE, what, remedy);
  }

  private static Finding journal(Path journal) {
    try (Stream<Path> files = Files.list(journal)) {
      long bytes = files.mapToLong(file -> file.toFile().length()).sum();
      String what = journal + " has " + size(bytes);
      return bytes < LARGE_JOURNAL
          ? Finding.ok(Subject.JOURNAL, what)
          : Finding.warn(
              Subject.JOURNAL,
              what + ", more than any robot's registrations need",
              "Take every robot down, move the folder away and bring them up again.");
    } catch (IOException e) {
      return Finding.fail(
          Subject.JOURNAL,
          journal + " cannot be read",
          "Run this as the user who brought the robots up, or correct the folder's permissions.");
    }
  }

  private static String size(long bytes) {
    if (bytes < MEGABYTE) {
      return bytes / KILOBYTE + " KB";
    }
    return bytes < 10 * GIGABYTE ? bytes / MEGABYTE + " MB" : bytes / GIGABYTE + " GB";
  }
}
