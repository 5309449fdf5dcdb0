package org.dfra.river.bootstrap;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The copy of the build's jars that this process was started from. {@code ./dfra build} removes a
 * copy only if no process runs from it and no phoenix will start one from it, for example after a
 * reboot. So each program that has phoenix write the copy's paths into its journal records that
 * here.
 */
final class BuildCopyUsage {

  /** A folder beside the jars, with one file for each state folder whose journal may name them. */
  private static final String NOTES = "states";

  private static final Logger LOG = LoggerFactory.getLogger(BuildCopyUsage.class);

  private BuildCopyUsage() {}

  /**
   * Records that a phoenix with this state starts processes from these jars. Does nothing if DFRA
   * is installed, because installed jars are not removed.
   *
   * <p>If the record cannot be written, for example without write permission beside the jars, a
   * warning is logged. The jars still stay while a process runs from them.
   *
   * @param state folder of phoenix's journal
   */
  static void recordUse(Path state) {
    @Nullable String lib = System.getProperty(DownloadJars.LIB);
    if (lib == null) {
      return;
    }
    try {
      recordUse(state, Path.of(lib).toAbsolutePath());
    } catch (IOException e) {
      LOG.warn(
          "It cannot be noted beside {} that {} needs those jars ({}); after a reboot, and a build by"
              + " somebody else, bring its robots up again",
          lib,
          state,
          e.toString());
    }
  }

  /**
   * As {@link #recordUse(Path)}, with an explicit folder.
   *
   * @param lib the folder of the jars
   */
  static void recordUse(Path state, Path lib) throws IOException {
    Path notes = lib.resolveSibling(NOTES);
    if (!Files.isDirectory(notes)) {
      return;
    }
    String folder = state.toAbsolutePath().normalize().toString();
    Path note = notes.resolve(Integer.toHexString(folder.hashCode()));
    if (!Files.exists(note) || !Files.readString(note).strip().equals(folder)) {
      Files.writeString(note, folder + "\n");
    }
  }
}
