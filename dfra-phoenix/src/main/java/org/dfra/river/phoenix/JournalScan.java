package org.dfra.river.phoenix;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/**
 * Checks a journal before River's reliable log reads it.
 *
 * <p>That log takes a record with a damaged length for the end and truncates the file there. It
 * takes a missing version file for a new journal. Either would silently lose acknowledged
 * registrations. This check changes nothing. It distinguishes a torn last record from a damaged one
 * that others follow.
 */
final class JournalScan {

  private static final int INT = Integer.BYTES;

  /** The magic number and the format come first. */
  private static final int FIRST_RECORD = 2 * INT;

  private JournalScan() {}

  /**
   * Refuses a damaged journal.
   *
   * @return whether its last record is torn
   * @throws IOException if more than that is damaged
   */
  static boolean check(Path folder) throws IOException {
    Path versionFile = folder.resolve("Version_Number");
    if (!Files.exists(versionFile) || Files.size(versionFile) < INT) {
      try (Stream<Path> files = Files.list(folder)) {
        if (files.anyMatch(file -> file.getFileName().toString().startsWith("Snapshot."))) {
          throw new IOException("its version file is missing or damaged");
        }
      }
      return false;
    }
    int version = ByteBuffer.wrap(Files.readAllBytes(versionFile)).getInt();
    Path log = folder.resolve("Logfile." + version);
    if (version == 0) {
      return false; // created, but nothing was acknowledged
    }
    if (!Files.exists(log)) {
      throw new IOException("its file " + log.getFileName() + " is missing");
    }
    return checkRecords(Files.readAllBytes(log));
  }

  private static boolean checkRecords(byte[] log) throws IOException {
    int at = FIRST_RECORD;
    int record = 1;
    while (isRecord(log, at)) {
      at = next(log, at);
      record++;
    }
    boolean end = at + INT >= log.length && (at + INT > log.length || intAt(log, at) == 0);
    if (end) {
      return false;
    }
    for (int later = at + INT; later < log.length; later += INT) {
      if (isRecord(log, later)) {
        throw new IOException("record " + record + " is damaged and others follow it");
      }
    }
    return true;
  }

  private static boolean isRecord(byte[] log, int at) {
    return at + INT <= log.length && JournalHandler.isWhole(log, at + INT, intAt(log, at));
  }

  /** Where the record after a good one begins: each is padded to four bytes. */
  private static int next(byte[] log, int at) {
    return at + INT + (intAt(log, at) + 3) / INT * INT;
  }

  private static int intAt(byte[] log, int at) {
    return ByteBuffer.wrap(log).getInt(at);
  }
}
