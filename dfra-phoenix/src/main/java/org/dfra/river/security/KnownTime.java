package org.dfra.river.security;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.security.cert.X509CRL;
import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;
import org.dfra.core.host.PrivateFiles;
import org.dfra.river.identity.FlooredClock;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.TeamCredentials;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The latest time that a computer knows of: the highest of what the authority has signed and of
 * what the computer's clock has shown. It is kept in a file, so that a robot whose clock begins in
 * 1970 after each start does not believe again what has expired.
 */
final class KnownTime {

  private static final Logger LOG = LoggerFactory.getLogger(KnownTime.class);

  private static final String LOCK = SecurityFiles.LATEST_TIME + ".lock";

  /** How much the file may be behind: a robot writes it about so often. */
  static final Duration STEP = Duration.ofMinutes(10);

  /** A lock of a file excludes other processes only. */
  private static final Object THIS_PROCESS = new Object();

  private final Path folder;
  private final Path file;
  private final FlooredClock clock;
  private final boolean isKept;
  private Instant kept;
  private boolean isFaultReported;

  private KnownTime(Path folder, FlooredClock clock, Instant kept, boolean isKept) {
    this.folder = folder;
    this.file = folder.resolve(SecurityFiles.LATEST_TIME);
    this.clock = clock;
    this.kept = kept;
    this.isKept = isKept;
  }

  /**
   * Reads it.
   *
   * @param folder with the identity
   * @param clock this computer's
   * @param isKept whether {@link #keep} writes the file: a process that ends soon need not
   */
  static KnownTime of(
      Path folder, TeamCredentials credentials, InstantSource clock, boolean isKept) {
    Instant kept = read(folder.resolve(SecurityFiles.LATEST_TIME)).orElse(Instant.EPOCH);
    // What has expired stays expired, and a clock that was wrong for once has no further effect.
    Instant latest = credentials.validity().until().plusSeconds(1);
    FlooredClock floored = new FlooredClock(clock, kept, latest);
    boolean unused = floored.learn(credentials.validity().from());
    KnownTime time = new KnownTime(folder, floored, kept, isKept);
    credentials.revocations().ifPresent(time::learn);
    return time;
  }

  private static Optional<Instant> read(Path file) {
    try {
      return Optional.of(Instant.parse(Files.readString(file).strip()));
    } catch (NoSuchFileException e) {
      return Optional.empty();
    } catch (IOException | DateTimeException e) {
      LOG.error("{} cannot be read, so only signed times count: {}", file, e.getMessage());
      return Optional.empty();
    }
  }

  /** The clock by which certificates are judged. */
  FlooredClock clock() {
    return clock;
  }

  /** Learns when the authority has signed a list. */
  void learn(X509CRL list) {
    boolean unused = clock.learn(list.getThisUpdate().toInstant());
  }

  /**
   * Learns what the clock shows, and writes the file if it is behind by more than {@link #STEP}.
   * For one thread.
   */
  void keep() {
    boolean unused = clock.learn(clock.instant());
    Instant now = clock.floor();
    if (!isKept || now.isBefore(kept.plus(STEP))) {
      return;
    }
    try {
      write(now);
      kept = now;
      isFaultReported = false;
    } catch (IOException e) { // the next attempt is soon
      if (!isFaultReported) {
        LOG.error("The time is not kept for the next start: {}", e.getMessage());
        isFaultReported = true;
      }
    }
  }

  private void write(Instant now) throws IOException {
    Path lock = folder.resolve(LOCK);
    PrivateFiles.makeFile(lock);
    synchronized (THIS_PROCESS) {
      try (FileChannel channel = FileChannel.open(lock, StandardOpenOption.WRITE);
          FileLock unused = channel.lock()) {
        if (read(file).orElse(Instant.EPOCH).isBefore(now)) { // another process may have written
          PrivateFiles.write(file, (now + "\n").getBytes(StandardCharsets.US_ASCII));
        }
      }
    }
  }

  /** Why this computer's clock does not count, in a sentence with the remedy; empty if it does. */
  Optional<String> fault() {
    return clock.isSet()
        ? Optional.empty()
        : Optional.of(
            "this computer's clock says "
                + clock.shown()
                + ", but it was "
                + clock.floor()
                + " or later before, so the clock was not set: certificates are judged by the later"
                + " time, and no time of a policy matches; set the clock, or if it is right,"
                + " take the robot down, delete "
                + file
                + " and bring it up");
  }
}
