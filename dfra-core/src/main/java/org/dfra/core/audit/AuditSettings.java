package org.dfra.core.audit;

import java.nio.file.Path;
import java.time.Duration;
import java.util.regex.Pattern;
import org.dfra.security.Member;
import org.dfra.text.PrintableText;

/**
 * Where a process keeps its audit trail, and how much of it.
 *
 * @param folder of the trail; several streams may share it; it becomes private (0700)
 * @param stream name of the stream, which only one process writes; {@link #STREAM_RULE}
 * @param owner whose trail it is, as heads name it: the member's text, such as {@code robot atrv1
 *     of field}, or another text of a process without a certificate
 * @param files largest number of files of the stream, 2 to 1000
 * @param bytesPerFile largest size of a file, bytes; at least {@value #LEAST_BYTES}
 * @param interval over which reads and equal events are summed, 100 ms to 1 h
 * @param queue how many records may wait for the disk; at least 16
 * @param ratePerInterval how many different events of members and of the process itself are
 *     recorded in an interval, at least 1
 * @param strangersRatePerInterval the same for callers without a valid certificate
 */
public record AuditSettings(
    Path folder,
    String stream,
    String owner,
    int files,
    long bytesPerFile,
    Duration interval,
    int queue,
    int ratePerInterval,
    int strangersRatePerInterval) {

  /** What the name of a stream may be. */
  public static final String STREAM_RULE = Member.NAME_RULE;

  /** The smallest size of a file, bytes: the longest possible record fits into it. */
  public static final long LEAST_BYTES = 32 * 1024;

  static final String STREAM = Member.NAME_FORM;

  private static final Pattern STREAM_NAME = Pattern.compile(STREAM);
  private static final int DEFAULT_FILES = 8;
  private static final int MOST_FILES = 1_000;
  private static final long DEFAULT_BYTES = 4L * 1024 * 1024;
  private static final Duration DEFAULT_INTERVAL = Duration.ofSeconds(10);
  private static final Duration LEAST_INTERVAL = Duration.ofMillis(100);
  private static final Duration LONGEST_INTERVAL = Duration.ofHours(1);
  private static final int DEFAULT_QUEUE = 4_096;
  private static final int LEAST_QUEUE = 16;
  private static final int DEFAULT_RATE = 500;
  private static final int DEFAULT_STRANGERS_RATE = 50;
  private static final int LONGEST_OWNER = 200;

  /**
   * Checks them.
   *
   * @throws IllegalArgumentException if one is out of its range; the message names both
   */
  public AuditSettings {
    if (!STREAM_NAME.matcher(stream).matches()) {
      throw new IllegalArgumentException(
          "the stream \"" + PrintableText.word(stream) + "\" is not " + STREAM_RULE);
    }
    owner = PrintableText.line(owner, LONGEST_OWNER);
    require(files >= 2 && files <= MOST_FILES, files + " files are not 2 to " + MOST_FILES);
    require(
        bytesPerFile >= LEAST_BYTES,
        bytesPerFile + " bytes for a file < least size " + LEAST_BYTES + " bytes");
    require(
        interval.compareTo(LEAST_INTERVAL) >= 0 && interval.compareTo(LONGEST_INTERVAL) <= 0,
        "interval " + interval.toMillis() + " ms is not 100 ms to 1 h");
    require(queue >= LEAST_QUEUE, "queue of " + queue + " records < " + LEAST_QUEUE);
    require(
        ratePerInterval >= 1 && strangersRatePerInterval >= 1,
        "a rate of less than 1 record for an interval");
  }

  private static void require(boolean isGood, String fault) {
    if (!isGood) {
      throw new IllegalArgumentException("audit trail: " + fault);
    }
  }

  /**
   * The defaults: 8 files of 4 MiB, sums of 10 s, and per interval 500 different events of members
   * and 50 of strangers.
   */
  public static AuditSettings of(Path folder, String stream, String owner) {
    return new AuditSettings(
        folder,
        stream,
        owner,
        DEFAULT_FILES,
        DEFAULT_BYTES,
        DEFAULT_INTERVAL,
        DEFAULT_QUEUE,
        DEFAULT_RATE,
        DEFAULT_STRANGERS_RATE);
  }

  /** The folder of the trail in a state folder. */
  public static Path folder(Path state) {
    return state.resolve("audit");
  }
}
