package org.dfra.sim.device.laser;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.Map;
import org.dfra.sim.device.UartDevice;
import org.dfra.sim.physics.RangeInput;
import org.jspecify.annotations.Nullable;

/**
 * Emulates a SICK LMS 200 at the byte level of its serial interface.
 *
 * <p>Commands: {@code 10} reset, {@code 20} operating mode (00 with the password installs, 24
 * streams, 25 sends on request, 40, 41, 42 and 48 change the baud rate), {@code 30 01} one scan,
 * {@code 31} status, {@code 32} errors, {@code 3A} type, {@code 3B} variant (not while it streams),
 * {@code 74} configuration, {@code 77} change of configuration (only while it installs). Each is
 * answered by ACK and a reply, everything else by {@code 92}, a damaged telegram by NAK. A new baud
 * rate applies after the answer was sent.
 *
 * <p>Its mirror rotates 75 times a second from right to left; a scan is sent when it is complete
 * and the send queue has capacity, so a slow link has fewer scans, not older ones. The
 * configuration survives a reset; variant, baud rate and mode do not. All of them survive a change
 * of client. It has no permanent baud rate.
 */
public final class LmsDevice extends UartDevice {

  private static final int WAKING_BAUD = 9600;
  private static final int DIRTY = 70; // per cent of a clean window
  private static final int CONFIGURATION_BYTES = 34;
  private static final int MODE_AT = 5;
  private static final int UNIT_AT = 6;
  private static final int STREAMS = 0x24;
  private static final int WAITS = 0x25;
  private static final int INSTALLS = 0x00;
  private static final byte[] PASSWORD = "SICK_LMS".getBytes(StandardCharsets.US_ASCII);
  private static final Map<Integer, Integer> BAUDS =
      Map.of(0x40, 38_400, 0x41, 19_200, 0x42, 9600, 0x48, 500_000);

  private final LmsMirror mirror;
  private final LmsEmulatorSettings makeup;
  private final LmsCommandReader commands = new LmsCommandReader(new CommandHandler());
  private final byte[] configuration = new byte[CONFIGURATION_BYTES];

  private @Nullable Instant powerOn;
  private @Nullable Instant powerOnReportAt; // null: it is ready
  private boolean resets; // when its send queue is empty
  private int nextBaud; // when its send queue is empty; 0: none
  private volatile int operatingMode = WAITS;
  private volatile int flashWrites;
  private Instant now = Instant.EPOCH;

  /**
   * @param view input of its sensor
   * @param makeup its settings
   */
  public LmsDevice(RangeInput view, LmsEmulatorSettings makeup) {
    super(makeup.baud() == 0 ? WAKING_BAUD : makeup.baud());
    this.mirror = new LmsMirror(view);
    this.makeup = makeup;
    configuration[MODE_AT] = (byte) makeup.measuringMode();
    configuration[UNIT_AT] = (byte) makeup.unit();
  }

  /** Number of configuration changes; any thread may call it. */
  public int flashWrites() {
    return flashWrites;
  }

  /** Whether it streams scans; any thread may call it. */
  public boolean isStreaming() {
    return operatingMode == STREAMS;
  }

  @Override
  public void receive(byte[] bytes, int offset, int length, Instant time) {
    advance(time);
    if (powerOnReportAt == null) {
      commands.feed(bytes, offset, length);
    }
  }

  @Override
  public void transmit(ByteBuffer out, Instant time) {
    super.transmit(out, time);
    applyPending(time);
  }

  @Override
  protected void advance(Instant time) {
    now = time;
    if (powerOn == null) {
      powerOn = time;
      powerOnReportAt = makeup.baud() == 0 ? time.plus(makeup.warmUp()) : null;
    }
    if (powerOnReportAt != null && !time.isBefore(powerOnReportAt)) {
      powerOnReportAt = null;
      channel().send(LmsTelegrams.telegram(0x90, LmsTelegrams.type(), status()), time);
    }
    if (powerOnReportAt == null && operatingMode == STREAMS && channel().waitingBytes() == 0) {
      stream(time);
    }
  }

  /** Actions delayed until the last byte of an answer. */
  private void applyPending(Instant time) {
    if (channel().waitingBytes() > 0) {
      return;
    }
    if (nextBaud != 0) {
      channel().setBaud(nextBaud);
      nextBaud = 0;
    }
    if (resets) {
      resets = false;
      channel().setBaud(WAKING_BAUD);
      operatingMode = WAITS;
      mirror.reset();
      powerOnReportAt = time.plus(makeup.warmUp());
    }
  }

  private void stream(Instant time) {
    Instant begin = mirror.complete(time);
    if (begin != null) {
      channel().send(LmsTelegrams.telegram(0xB0, scan(begin), status()), time);
    }
  }

  private byte[] scan(Instant begin) {
    return LmsTelegrams.scan(unit(), mirror.samples(begin, unit(), configuration[MODE_AT]));
  }

  private int unit() {
    return configuration[UNIT_AT];
  }

  /** Status byte: laser family and error state. */
  private int status() {
    int worst =
        makeup.errors().stream()
            .mapToInt(LmsEmulatorSettings.StoredError::type)
            .filter(t -> t < 8)
            .max()
            .orElse(0);
    return 0x10 | worst | (makeup.windowCleanness() < DIRTY ? 0x80 : 0);
  }

  private void answer(int command, byte... data) {
    channel().send(LmsTelegrams.reply(command, data, status()), now);
  }

  /** Executes commands. */
  private final class CommandHandler implements LmsCommandReader.Sink {

    @Override
    public void damaged() {
      channel().send(LmsTelegrams.NAK, now);
    }

    @Override
    public void command(byte[] payload) {
      switch (payload[0]) {
        case 0x10 -> {
          resets = true;
          answer(0x91);
        }
        case 0x20 -> changeMode(payload);
        case 0x30 -> {
          if (payload.length == 2 && payload[1] == 1) {
            answer(0xB0, scan(now.minusNanos(mirror.periodNanos())));
          } else {
            answer(0x92);
          }
        }
        case 0x31 -> answer(0xB1, LmsTelegrams.status(condition()));
        case 0x32 -> answer(0xB2, LmsTelegrams.errors(makeup.errors()));
        case 0x3A -> answer(0xBA, LmsTelegrams.type());
        case 0x3B -> changeVariant(payload);
        case 0x74 -> answer(0xF4, configuration);
        case 0x77 -> changeConfiguration(payload);
        default -> answer(0x92);
      }
    }

    private LmsTelegrams.Condition condition() {
      double seconds = powerOn == null ? 0 : Duration.between(powerOn, now).toMillis() / 1e3;
      return new LmsTelegrams.Condition(
          operatingMode,
          makeup.windowCleanness(),
          (int) ((long) (seconds * LmsMirror.REVOLUTIONS_PER_SECOND) & 0xFFFF),
          configuration[MODE_AT],
          mirror.degrees(),
          mirror.hundredths(),
          channel().baud(),
          unit());
    }

    private void changeMode(byte[] payload) {
      int mode = payload.length < 2 ? -1 : payload[1];
      Integer baud = BAUDS.get(mode);
      if (baud != null && payload.length == 2) {
        nextBaud = baud;
        operatingMode = WAITS;
        answer(0xA0, (byte) 0);
      } else if (mode == INSTALLS) {
        boolean isRight = Arrays.equals(Arrays.copyOfRange(payload, 2, payload.length), PASSWORD);
        operatingMode = isRight ? INSTALLS : operatingMode;
        answer(0xA0, (byte) (isRight ? 0 : 1));
      } else if ((mode == STREAMS || mode == WAITS) && payload.length == 2) {
        operatingMode = mode;
        mirror.beginStream(now);
        answer(0xA0, (byte) 0);
      } else {
        answer(0x92);
      }
    }

    private void changeVariant(byte[] payload) {
      if (payload.length != 5 || operatingMode == STREAMS) {
        answer(0x92);
        return;
      }
      int field = payload[1] & 0xFF | payload[2] << 8;
      int step = payload[3] & 0xFF | payload[4] << 8;
      boolean isDone = !makeup.isConfigurationLocked() && mirror.setVariant(field, step);
      answer(0xBB, LmsTelegrams.variant(isDone, mirror.degrees(), mirror.hundredths()));
    }

    private void changeConfiguration(byte[] payload) {
      boolean isDone =
          operatingMode == INSTALLS
              && payload.length == 1 + CONFIGURATION_BYTES
              && LmsMirror.isKnownUnit(payload[1 + UNIT_AT])
              && !makeup.isConfigurationLocked();
      if (isDone) {
        System.arraycopy(payload, 1, configuration, 0, CONFIGURATION_BYTES);
        flashWrites++;
      }
      byte[] data = new byte[1 + CONFIGURATION_BYTES];
      data[0] = (byte) (isDone ? 1 : 0);
      System.arraycopy(configuration, 0, data, 1, CONFIGURATION_BYTES);
      answer(0xF7, data);
    }
  }
}
