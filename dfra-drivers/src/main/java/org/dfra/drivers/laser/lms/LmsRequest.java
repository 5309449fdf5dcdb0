package org.dfra.drivers.laser.lms;

import java.time.Duration;

/**
 * A request to the laser. One request is pending at a time.
 *
 * @param kind its kind
 * @param telegram the bytes to send
 */
record LmsRequest(Kind kind, byte[] telegram) {

  /** The kind of a request, its answer, and the timeout. */
  enum Kind {
    /** Sends scans only on request; ends a stream and installation mode. */
    STOP("A0", 1500, "to wait for orders"),
    /** Queries its status. */
    STATUS("B1", 1500, "how it is"),
    /** Sets its baud rate. */
    BAUD("A0", 1500, "to change its baud rate"),
    /** Queries its type. */
    TYPE("BA", 1500, "what it is"),
    /** Queries its configuration. */
    CONFIGURATION("F4", 1500, "for its configuration"),
    /** Enters installation mode. */
    INSTALLATION("A0", 3000, "to enter installation mode"),
    /** Changes its configuration; flash memory is slow. */
    CONFIGURE("F7", 15_000, "to change its configuration"),
    /** Sets its field of view and resolution. */
    VARIANT("BB", 3000, "to change its field of view and resolution"),
    /** Queries its stored errors. */
    ERRORS("B2", 1500, "for its errors"),
    /** Streams scans. */
    STREAM("A0", 1500, "to stream scans"),
    /** Requests one scan. */
    SCAN("B0", 2000, "for a scan"),
    /** Restarts the laser. */
    RESET("91", 3000, "to reset itself");

    private final String answer;
    private final Duration patience;
    private final String words;

    Kind(String answer, int millis, String words) {
      this.answer = answer;
      this.patience = Duration.ofMillis(millis);
      this.words = words;
    }

    /** Name of the answer's message. */
    String answer() {
      return answer;
    }

    /** Timeout for the answer. */
    Duration timeout() {
      return patience;
    }

    /** Completes the sentence {@code the laser was asked …}. */
    String words() {
      return words;
    }
  }

  static final LmsRequest STOP = new LmsRequest(Kind.STOP, LmsCommands.stop());
  static final LmsRequest STATUS = new LmsRequest(Kind.STATUS, LmsCommands.status());
  static final LmsRequest TYPE = new LmsRequest(Kind.TYPE, LmsCommands.type());
  static final LmsRequest ERRORS = new LmsRequest(Kind.ERRORS, LmsCommands.errors());
  static final LmsRequest STREAM = new LmsRequest(Kind.STREAM, LmsCommands.stream());
  static final LmsRequest SCAN = new LmsRequest(Kind.SCAN, LmsCommands.scan());
  static final LmsRequest RESET = new LmsRequest(Kind.RESET, LmsCommands.reset());
  static final LmsRequest CONFIGURATION =
      new LmsRequest(Kind.CONFIGURATION, LmsCommands.configuration());
  static final LmsRequest INSTALLATION =
      new LmsRequest(Kind.INSTALLATION, LmsCommands.installation());

  static LmsRequest baud(LmsBaud baud) {
    return new LmsRequest(Kind.BAUD, LmsCommands.baud(baud));
  }

  static LmsRequest variant(LmsVariant variant) {
    return new LmsRequest(Kind.VARIANT, LmsCommands.variant(variant));
  }

  static LmsRequest configure(LmsConfiguration configuration) {
    return new LmsRequest(Kind.CONFIGURE, LmsCommands.configure(configuration));
  }
}
