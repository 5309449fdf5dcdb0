package org.dfra.drivers.laser.lms;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.dfra.drivers.laser.lms.LmsConfiguration.LmsUnit;
import org.dfra.drivers.laser.lms.LmsRequest.Kind;
import org.jspecify.annotations.Nullable;

/**
 * Configures the laser: from the laser's known state it selects the next request, until the laser
 * has the required settings. {@link #next} defines the order of requests; changed settings need no
 * order.
 *
 * <p>Confined to the reader thread, except {@link #enqueue} and {@link #writes}.
 */
final class LmsConfigurator {

  /** Maximum number of flash writes per run of the driver: flash memory wears out. */
  private static final int MOST_WRITES = 3;

  /** Maximum number of attempts to change the rate of a laser that reports another one. */
  private static final int TRIES = 3;

  private final LmsSettings settings;
  private final ConcurrentLinkedQueue<LmsRequest> inquiries = new ConcurrentLinkedQueue<>();
  private final Set<Kind> vain = EnumSet.noneOf(Kind.class); // rejected, or not to be retried

  private boolean stopped;
  private boolean streaming;
  private boolean installing;
  private boolean wrote;
  private @Nullable LmsStatus status;
  private @Nullable String type;
  private @Nullable LmsConfiguration configuration;
  private @Nullable LmsVariant variant;
  private @Nullable LmsVariant refusedVariant;
  private int switches;
  private volatile int writes; // written by the reader

  LmsConfigurator(LmsSettings orders) {
    this.settings = orders;
  }

  /** Discards the known state: another laser, or one that was reset. */
  void forget() {
    inquiries.clear();
    vain.clear();
    refusedVariant = null;
    wrote = false;
    switches = 0;
    type = null;
    lost();
  }

  /** The laser no longer answers at this rate. */
  void lost() {
    stopped = false;
    streaming = false;
    installing = false;
    status = null;
    configuration = null;
    variant = null;
  }

  /** Queues a request; from any thread. */
  void enqueue(LmsRequest request) {
    inquiries.add(request);
  }

  /**
   * The next request; null when the laser has the required settings.
   *
   * @param baud the link's rate, where the laser does not report it
   * @param isIdle whether no scans are required now
   */
  @Nullable LmsRequest next(Optional<LmsBaud> baud, boolean isIdle) {
    LmsStatus reported = status;
    if (!stopped && !streaming) {
      return LmsRequest.STOP;
    }
    if (reported == null) {
      return quietly(LmsRequest.STATUS);
    }
    Optional<LmsBaud> target = settings.baud();
    if (target.isPresent()
        && !target.equals(reported.baud().isPresent() ? reported.baud() : baud)
        && switches < TRIES
        && !vain.contains(Kind.BAUD)) {
      return quietly(LmsRequest.baud(target.get()));
    }
    LmsRequest setting = setting();
    if (setting != null) {
      return quietly(setting);
    }
    if (!inquiries.isEmpty()) {
      return streaming ? LmsRequest.STOP : inquiries.poll();
    }
    boolean wantsStream = !isIdle && !settings.isPolled() && unusableReason() == null;
    if (streaming != wantsStream) {
      return wantsStream ? LmsRequest.STREAM : LmsRequest.STOP;
    }
    return null;
  }

  private @Nullable LmsRequest setting() {
    if (type == null && !vain.contains(Kind.TYPE)) {
      return LmsRequest.TYPE;
    }
    LmsConfiguration now = configuration;
    if (now == null) {
      return LmsRequest.CONFIGURATION;
    }
    LmsConfiguration target = targetConfiguration(now);
    if (!target.equals(now)
        && !wrote
        && writes < MOST_WRITES
        && !vain.contains(Kind.INSTALLATION)) {
      return installing ? LmsRequest.configure(target) : LmsRequest.INSTALLATION;
    }
    if (installing) {
      return LmsRequest.STOP;
    }
    LmsVariant beams = settings.variant();
    if (!beams.equals(variant) && !beams.equals(refusedVariant)) {
      return LmsRequest.variant(beams);
    }
    return null;
  }

  private LmsConfiguration targetConfiguration(LmsConfiguration now) {
    LmsConfiguration unit = settings.unit().map(now::with).orElse(now);
    return settings.measuringMode().map(unit::with).orElse(unit);
  }

  /** Stops a stream before any other request. */
  private LmsRequest quietly(LmsRequest request) {
    return streaming ? LmsRequest.STOP : request;
  }

  /** Processes the laser's answer; returns a warning for the operator, a sentence, or null. */
  @Nullable String answered(Kind kind, LmsMessage answer) {
    if (answer instanceof LmsMessage.ModeReply set) {
      return set.isDone() ? entered(kind) : refused(kind);
    } else if (answer instanceof LmsStatus reported) {
      status = reported;
      variant = reported.variant().orElse(null);
    } else if (answer instanceof LmsMessage.TypeReply reported) {
      type = reported.type();
    } else if (answer instanceof LmsMessage.ConfigurationReply reported) {
      configuration = reported.configuration();
      return wrote
              && !targetConfiguration(reported.configuration()).equals(reported.configuration())
          ? "the laser's flash was written, but the laser still has " + inWords()
          : null;
    } else if (answer instanceof LmsMessage.ConfigurationChangeReply set) {
      configuration = null; // repeated, after installation mode
      return set.isDone() ? null : refused(kind);
    } else if (answer instanceof LmsMessage.VariantReply set) {
      variant = set.variant();
      return set.isDone() ? null : refused(kind);
    }
    return null;
  }

  private @Nullable String entered(Kind kind) {
    stopped = kind != Kind.STREAM;
    streaming = kind == Kind.STREAM;
    installing = kind == Kind.INSTALLATION;
    if (kind == Kind.BAUD) {
      status = null; // shows that it answers at that rate
    }
    return null;
  }

  /** The laser has rejected a request; returns a warning for the operator, a sentence. */
  String refused(Kind kind) {
    vain.add(kind);
    if (kind == Kind.CONFIGURE) {
      vain.add(Kind.INSTALLATION);
    } else if (kind == Kind.VARIANT) {
      refusedVariant = settings.variant();
      return "the laser refuses " + settings.variant().inWords() + " and keeps " + inWords();
    }
    return "the laser was asked " + kind.words() + " and refuses; it keeps " + inWords();
  }

  /** Gives up a request that would fail again. */
  void giveUp(Kind kind) {
    vain.add(kind);
  }

  /** A request has been sent. */
  void sent(Kind kind) {
    if (kind == Kind.CONFIGURE) { // counts even without an answer
      wrote = true;
      writes = writes + 1;
    } else if (kind == Kind.BAUD) {
      switches++;
    }
  }

  /** The known state is not correct: queries the laser's settings again. */
  void invalidate() {
    status = null;
    configuration = null;
  }

  /** Its field of view and resolution; null while unknown. */
  @Nullable LmsVariant variant() {
    return variant;
  }

  /** Its measuring mode; empty while unknown. */
  Optional<MeasuringMode> mode() {
    LmsConfiguration now = configuration;
    return now == null ? Optional.empty() : now.mode();
  }

  /** Why its scans cannot be interpreted, as a clause; null where they can. */
  @Nullable String unusableReason() {
    LmsConfiguration now = configuration;
    if (now != null && now.mode().isEmpty()) {
      return "its measuring mode is "
          + now.modeCode()
          + ", whose samples cannot be interpreted; set measuring_mode";
    }
    LmsVariant beams = variant;
    return now != null && beams == null ? "the directions of its beams are not known" : null;
  }

  /** Whether it has the required settings, or the nearest possible ones. */
  boolean isConfigured() {
    return status != null && configuration != null && !installing;
  }

  boolean isStreaming() {
    return streaming;
  }

  int flashWrites() {
    return writes;
  }

  private String inWords() {
    LmsConfiguration now = configuration;
    LmsVariant beams = variant;
    return (now == null ? "its configuration" : "measuring mode " + now.modeCode())
        + (now == null ? "" : " in " + now.unit().map(LmsUnit::word).orElse("unknown units"))
        + (beams == null ? "" : ", " + beams.inWords());
  }
}
