package org.dfra.drivers.laser.lms;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.dfra.drivers.laser.lms.LmsRequest.Kind;
import org.jspecify.annotations.Nullable;

/**
 * What is known of the laser, and so what is to be asked or told next until it is as wanted. The
 * order of {@link #next} is the order of things; whoever changes a wish needs not care.
 *
 * <p>Confined to the reader thread, but for {@link #enqueue} and {@link #writes}.
 */
final class LmsConfigurator {

  /** The flash memory is written so often at most in a driver's life: it wears out. */
  private static final int MOST_WRITES = 3;

  /** A laser that says that it is at another speed than it was told is not told for ever. */
  private static final int TRIES = 3;

  private final LmsSettings settings;
  private final ConcurrentLinkedQueue<LmsRequest> inquiries = new ConcurrentLinkedQueue<>();
  private final Set<Kind> vain = EnumSet.noneOf(Kind.class); // refused, or not to be tried again

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

  /** Nothing is known any more: another laser, or one that was reset. */
  void forget() {
    inquiries.clear();
    vain.clear();
    refusedVariant = null;
    wrote = false;
    switches = 0;
    type = null;
    lost();
  }

  /** The laser does not answer any more, as far as is known at this speed. */
  void lost() {
    stopped = false;
    streaming = false;
    installing = false;
    status = null;
    configuration = null;
    variant = null;
  }

  /** Has something asked when there is time; from any thread. */
  void enqueue(LmsRequest request) {
    inquiries.add(request);
  }

  /**
   * What is to be asked or told next; null where all is as wanted.
   *
   * @param baud the speed of the line, where the laser does not tell it
   * @param isIdle whether no scans are wanted now
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

  /** A stream is ended before the laser is asked for anything else. */
  private LmsRequest quietly(LmsRequest request) {
    return streaming ? LmsRequest.STOP : request;
  }

  /** Takes what the laser answered; returns what people should know of it, a sentence, or null. */
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
      configuration = null; // asked again, after installation mode
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
      status = null; // shows that it answers at that speed
    }
    return null;
  }

  /** The laser does not do it; returns what people should know, a sentence. */
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

  /** It is of no use to try that again. */
  void giveUp(Kind kind) {
    vain.add(kind);
  }

  /** It is under way to the laser. */
  void sent(Kind kind) {
    if (kind == Kind.CONFIGURE) { // counts even if no answer comes
      wrote = true;
      writes = writes + 1;
    } else if (kind == Kind.BAUD) {
      switches++;
    }
  }

  /** Something is not as it was known to be: what the laser is set to is asked again. */
  void invalidate() {
    status = null;
    configuration = null;
  }

  /** Where its beams are; null while that is not known. */
  @Nullable LmsVariant variant() {
    return variant;
  }

  /** What of its samples is the distance; empty while that is not known. */
  Optional<MeasuringMode> mode() {
    LmsConfiguration now = configuration;
    return now == null ? Optional.empty() : now.mode();
  }

  /** Why its scans cannot be understood, as a clause; null where they can. */
  @Nullable String unusableReason() {
    LmsConfiguration now = configuration;
    if (now != null && now.mode().isEmpty()) {
      return "its measuring mode is "
          + now.modeCode()
          + ", of which nobody knows what its samples mean; set measuring_mode";
    }
    LmsVariant beams = variant;
    return now != null && beams == null ? "nobody knows where its beams are" : null;
  }

  /** Whether it is as wanted, or as near to that as can be. */
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
