package org.dfra.drivers.gps.m12;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.dfra.drivers.link.LinkUser;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.sensor.GpsFix;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * What is said between the driver and the receiver, from one opening of the link to the next.
 *
 * <p>It asks for {@code @@Cj}, for time as UTC and for {@code @@Ha} at the set rate. A receiver
 * that has sent no {@code @@Ha} after {@value #PATIENCE_SECONDS} s is asked for {@code @@Ea} too,
 * since it may have eight channels only. Once a {@code @@Ha} has come, {@code @@Ea} is no longer
 * listened to, and the receiver is told to stop it if it was asked for.
 *
 * <p>Confined to the reader thread.
 */
final class M12Dialogue implements LinkUser {

  /** Is told what the receiver says; on the reader thread. */
  interface Listener {

    /** A solution, with a position or without. */
    void solved(M12PositionMessage message);

    /** The receiver has set itself to its defaults. */
    void defaulted();

    /** The link is open. */
    void opened();

    /** What the receiver is. */
    void identified(ReceiverIdentification identification);

    /** Bytes have come. */
    void counted(M12Counts counts);

    /**
     * The last position is too old to be served, or there is no device to serve one.
     *
     * @param awaits what is missing, as a clause
     */
    void withoutPosition(String awaits);
  }

  private static final int PATIENCE_SECONDS = 2;

  private final M12Rate rate;
  private final Ticker ticker;
  private final Logger log;
  private final Listener listener;
  private final M12Parser parser = new M12Parser(this::heard);

  /** What others want to be sent; sent by the reader, which alone has the link. */
  private final ConcurrentLinkedQueue<byte[]> outbox = new ConcurrentLinkedQueue<>();

  private int toldRate;
  private boolean toBeTold;
  private long openedNanos;
  private long solvedNanos;
  private long positionNanos;
  private boolean has12Channels;
  private boolean asked8Channels;
  private boolean toldMalformed;
  private String state = "";

  /**
   * @param rate how often positions are wanted, and how long without one the receiver is taken for
   *     lost
   */
  M12Dialogue(M12Rate rate, Ticker ticker, Logger log, Listener listener) {
    this.rate = rate;
    this.ticker = ticker;
    this.log = log;
    this.listener = listener;
  }

  @Override
  public void opened(SerialLink link) throws IOException {
    openedNanos = ticker.nanos();
    solvedNanos = openedNanos;
    positionNanos = openedNanos;
    has12Channels = false;
    asked8Channels = false;
    toldMalformed = false;
    state = link + " is open, no position frame has come yet";
    listener.withoutPosition(state);
    outbox.clear();
    listener.opened();
    begin(link);
  }

  private void begin(SerialLink link) throws IOException {
    toBeTold = false;
    link.write(M12Commands.identification());
    link.write(M12Commands.utcTime());
    toldRate = rate.now();
    link.write(M12Commands.positionOf12Channels(toldRate));
  }

  /** Has a command sent soon; from any thread. Forgotten when the link is opened anew first. */
  void send(byte[] command) {
    outbox.add(command);
  }

  @Override
  public boolean received(byte[] bytes, int length) {
    long before = parser.counts().frames();
    parser.feed(bytes, 0, length);
    M12Counts counts = parser.counts();
    listener.counted(counts);
    return counts.frames() > before;
  }

  @Override
  public @Nullable String tend(SerialLink link) throws IOException {
    for (byte[] command = outbox.poll(); command != null; command = outbox.poll()) {
      link.write(command);
    }
    if (toBeTold) {
      begin(link);
      asked8Channels = false;
      openedNanos = ticker.nanos();
    }
    tellRate(link);
    long now = ticker.nanos();
    Duration silence = rate.longestAge();
    if (now - solvedNanos > silence.toNanos()) {
      return "no position frame for " + silence.toSeconds() + " s";
    }
    if (now - positionNanos > silence.toNanos()) {
      listener.withoutPosition(state);
    }
    if (has12Channels && asked8Channels) {
      asked8Channels = false;
      link.write(M12Commands.positionOf8Channels(0)); // one more, then none
    } else if (!has12Channels
        && !asked8Channels
        && now - openedNanos > Duration.ofSeconds(PATIENCE_SECONDS).toNanos()) {
      asked8Channels = true;
      link.write(M12Commands.positionOf8Channels(toldRate));
    }
    return null;
  }

  private void tellRate(SerialLink link) throws IOException {
    int wanted = rate.now();
    if (wanted != toldRate) {
      toldRate = wanted;
      link.write(M12Commands.positionOf12Channels(wanted));
      if (asked8Channels) {
        link.write(M12Commands.positionOf8Channels(wanted));
      }
    }
  }

  @Override
  public void lost(String reason) {
    parser.finish();
    listener.counted(parser.counts());
    listener.withoutPosition(reason);
  }

  private void heard(M12Message message) {
    if (message instanceof Position12Channels position) {
      has12Channels = true;
      solved(position);
    } else if (message instanceof Position8Channels position) {
      if (!has12Channels) {
        solved(position);
      }
    } else if (message instanceof ReceiverIdentification identification) {
      listener.identified(identification);
    } else if (message instanceof OtherMessage other && other.id().equals("Cf")) {
      toBeTold = true; // it sends nothing any more
      listener.defaulted();
    } else if (message instanceof MalformedMessage malformed) {
      if (toldMalformed) {
        log.debug("malformed @@{}: {}", malformed.id(), malformed.reason());
      } else {
        toldMalformed = true;
        log.warn(
            "malformed @@{}: {}; more of them until the link is opened again are told at DEBUG",
            malformed.id(),
            malformed.reason());
      }
    }
  }

  private void solved(M12PositionMessage message) {
    solvedNanos = ticker.nanos();
    if (toldRate == rate.now()) {
      rate.arrived();
    }
    state = "the receiver has no position, it is " + message.stateInWords();
    if (message.mode() != GpsFix.Mode.NONE) {
      positionNanos = solvedNanos;
    }
    listener.solved(message);
  }
}
