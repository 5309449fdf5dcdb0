package org.dfra.river.phoenix.host;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * Finds the process that holds the lock of a file. Linux lists it in {@code /proc/locks}. Elsewhere
 * it is the process whose number is in the file, if that process runs.
 */
final class LockHolderFinder {

  /** proc_locks(5): number, kind, ADVISORY, READ or WRITE, process, device:inode, from, to. */
  private static final int FIELDS = 8;

  private static final int KIND = 1;
  private static final int PROCESS = 4;
  private static final int FILE = 5;

  private final Path proc;

  /**
   * @param proc the folder {@code /proc}
   */
  LockHolderFinder(Path proc) {
    this.proc = proc;
  }

  /**
   * Describes the holder, such as {@code process 4711 of user nobody}.
   *
   * @param file whose lock is held; it is read, so this process must hold no lock of it
   */
  String of(Path file) {
    try {
      OptionalLong locks = locking(file);
      OptionalLong pid = locks.isPresent() ? locks : written(file);
      return pid.isPresent() ? inWords(pid.getAsLong()) : "an unknown process";
    } catch (IOException | UnsupportedOperationException | IllegalArgumentException e) {
      return "a process that cannot be identified (" + e + ")";
    }
  }

  /** Describes a process and its user. */
  String inWords(long pid) {
    Path process = proc.resolve(Long.toString(pid));
    try {
      return "process " + pid + " of user " + Files.getOwner(process).getName();
    } catch (IOException e) {
      return "process " + pid; // there is no /proc, or it hides other users' processes
    }
  }

  /** The process that locks this file. Locks of open files, which have no process, are -1. */
  private OptionalLong locking(Path file) throws IOException {
    Path table = proc.resolve("locks");
    if (!Files.isReadable(table)) {
      return OptionalLong.empty();
    }
    long device = ((Number) Files.getAttribute(file, "unix:dev")).longValue();
    long inode = ((Number) Files.getAttribute(file, "unix:ino")).longValue();
    String suffix = ":" + inode;
    List<String[]> ofInode =
        Files.readAllLines(table, StandardCharsets.US_ASCII).stream()
            .map(line -> line.strip().split("\\s+"))
            .filter(fields -> fields.length >= FIELDS && fields[KIND].equals("POSIX"))
            .filter(fields -> fields[FILE].endsWith(suffix))
            .filter(fields -> Long.parseLong(fields[PROCESS]) > 0)
            .toList();
    String exact = "%02x:%02x%s".formatted(major(device), minor(device), suffix);
    return ofInode.stream()
        .filter(fields -> fields[FILE].equals(exact))
        .findFirst()
        // On stacked file systems, the table has another device than the file.
        .or(() -> ofInode.size() == 1 ? ofInode.stream().findFirst() : Optional.empty())
        .map(fields -> OptionalLong.of(Long.parseLong(fields[PROCESS])))
        .orElse(OptionalLong.empty());
  }

  /** The major number of a device number in the C library's format, makedev(3). */
  private static long major(long device) {
    return ((device >> 8) & 0xfffL) | ((device >> 32) & ~0xfffL);
  }

  private static long minor(long device) {
    return (device & 0xffL) | ((device >> 12) & 0xffffff00L);
  }

  private static OptionalLong written(Path file) throws IOException {
    String text = Files.readString(file, StandardCharsets.ISO_8859_1).strip();
    if (!text.matches("\\d{1,18}")) {
      return OptionalLong.empty();
    }
    long pid = Long.parseLong(text);
    return ProcessHandle.of(pid).isPresent() ? OptionalLong.of(pid) : OptionalLong.empty();
  }
}
