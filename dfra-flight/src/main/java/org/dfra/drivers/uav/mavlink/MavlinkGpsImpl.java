package org.dfra.drivers.uav.mavlink;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.GpsReceiverPersona;
import org.dfra.drivers.gps.GpsReceiverType;
import org.dfra.drivers.gps.WeekRollover;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.LinkSettings;
import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.uav.mavlink.MavlinkCatalogue.MessageIds;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.GpsRaw;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.SystemTime;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.NotReadyException;
import org.dfra.module.Precondition;
import org.dfra.persona.Attributes;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.SensorAttributes;
import org.jspecify.annotations.Nullable;

/**
 * The satellite receiver of an unmanned aerial vehicle, as forwarded by its autopilot: {@code
 * GPS_RAW_INT}, with {@code SYSTEM_TIME} for the date. It is the receiver's own solution and not
 * the autopilot's estimate, so that it has the same meaning as a {@link GPSSensor} on the ground;
 * the estimate is in {@link MavlinkFlightImpl#flightState}.
 *
 * <p>Parameters, besides those of {@link MavlinkSensorImpl}; read-only: {@code satellites}, {@code
 * accuracy}.
 *
 * <p>The height is that above the ellipsoid. MAVLink 1 and old autopilots report only the height
 * above mean sea level: then the fix is 2-D and its height 0. The dilution of a 3-D fix is computed
 * from HDOP and VDOP. MAVLink has one number of satellites, which is used for both visible and
 * tracked.
 *
 * <p>The time of a fix is the autopilot's: since 1970 or, by way of {@code SYSTEM_TIME}, since it
 * was switched on. While the date is unknown, {@link #time} throws, and a fix has the time of its
 * arrival. MAVLink does not report whether leap seconds are known; autopilots wait for them.
 *
 * <p>Test, besides: {@code satellites}, at least four are used. Preconditions: those of every
 * satellite receiver.
 */
public final class MavlinkGpsImpl extends MavlinkSensorImpl<MavlinkGpsImpl.Snapshot>
    implements GPSSensor {

  private static final int ENOUGH = 4;

  private static final SensorAttributes SENSOR =
      new SensorAttributes(
          "GpsFix",
          List.of("continuous"),
          1.0 / 60,
          20,
          null,
          List.of("The antenna sees the open sky."));

  private static final GpsReceiverAttributes RECEIVER =
      new GpsReceiverAttributes(null, null, null, null, null, List.of("2D", "3D"));

  /**
   * The receiver's last reports; immutable.
   *
   * @param time null while the date is unknown
   */
  record Snapshot(GpsFix fix, LocationReading location, @Nullable TimeReading time, GpsRaw raw) {}

  private final GpsReceiverPersona attributes = new GpsReceiverPersona(SENSOR);
  private final WeekRollover rollover = WeekRollover.of(clock(), LinkSettings.address(settings()));
  private @Nullable Instant switchedOn; // confined to the reader; from SYSTEM_TIME

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public MavlinkGpsImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /** For tests: uses the given clock and source of links. */
  MavlinkGpsImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    super(
        context,
        "satellite receiver of an autopilot, by MAVLink",
        "GPS_RAW_INT",
        List.of("GpsFix", "LocationReading", "TimeReading"),
        List.of(new Precondition("speed", 0, 500, "m/s"), GpsReceiverType.SATELLITES),
        ticker,
        source);
    diagnostics().addTest("satellites", this::satellites);
    parameterTable().declareReadOnly("satellites", "how many it uses", () -> satellites().text());
    parameterTable()
        .declareReadOnly("accuracy", "the receiver's estimate of its error", this::accuracy);
  }

  @Override
  Map<Integer, Double> messageRates(double rate) {
    return Map.of(MessageIds.GPS_RAW_INT, rate, MessageIds.SYSTEM_TIME, Math.min(rate, 1));
  }

  @Override
  void messageReceived(MavlinkMessage message) {
    if (message instanceof SystemTime time) {
      switchedOn = time.utc() == null ? null : time.utc().minus(time.boot());
    } else if (message instanceof GpsRaw raw) {
      solved(raw);
    }
  }

  private void solved(GpsRaw raw) {
    Instant now = clock().instant();
    @Nullable Instant utc = utc(raw.time());
    GpsFix fix = fix(raw, utc == null ? now : utc);
    @Nullable GeoPosition position = fix.position();
    @Nullable Snapshot last = latest().peek();
    if (position == null) {
      reportUnusable(
          "the receiver has no position, it uses " + fix.satellitesTracked() + " satellites");
      if (last == null) {
        return;
      }
      latest().replaceValue(new Snapshot(fix, last.location(), last.time(), raw));
    } else {
      LocationReading location = new LocationReading(position, path(), fix.utc());
      attributes.located(location);
      markDelivered(
          new Snapshot(fix, location, utc == null ? null : new TimeReading(utc, now), raw));
    }
    publish(fix);
  }

  private @Nullable Instant utc(Duration time) {
    if (MavlinkDecoder.isSince1970(time)) {
      return rollover.correct(Instant.EPOCH.plus(time));
    }
    return switchedOn == null ? null : rollover.correct(switchedOn.plus(time));
  }

  private static GpsFix fix(GpsRaw raw, Instant utc) {
    GpsFix.Mode mode = mode(raw);
    boolean hasHeight = mode != GpsFix.Mode.FIX_2D && raw.height() != null;
    int satellites = raw.satellites() == null ? 0 : raw.satellites();
    return new GpsFix(
        mode,
        mode == GpsFix.Mode.NONE
            ? null
            : new GeoPosition(
                raw.latitude(),
                raw.longitude(),
                hasHeight ? Objects.requireNonNull(raw.height()) : 0),
        utc,
        raw.speed() == null ? Double.NaN : raw.speed(),
        raw.course() == null ? Double.NaN : raw.course(),
        mode == GpsFix.Mode.FIX_3D
            ? Math.hypot(orZero(raw.horizontalDilution()), orZero(raw.verticalDilution()))
            : orZero(raw.horizontalDilution()),
        satellites,
        satellites);
  }

  private static GpsFix.Mode mode(GpsRaw raw) {
    return switch (raw.fixType()) {
      case 2 -> GpsFix.Mode.FIX_2D;
      case 3, 4, 5, 6, 8 -> raw.height() == null ? GpsFix.Mode.FIX_2D : GpsFix.Mode.FIX_3D;
      case 7 -> GpsFix.Mode.POSITION_HOLD;
      default -> GpsFix.Mode.NONE;
    };
  }

  private static double orZero(@Nullable Double value) {
    return value == null ? 0 : value;
  }

  private DiagnosticFinding satellites() {
    @Nullable Snapshot now = latest().peek();
    int used = now == null ? 0 : now.fix().satellitesTracked();
    return new DiagnosticFinding(used >= ENOUGH, used + " are used, and " + ENOUGH + " are enough");
  }

  private String accuracy() {
    @Nullable Snapshot now = latest().peek();
    return now == null || now.raw().horizontalAccuracy() == null
        ? "not reported"
        : String.format(
            Locale.ROOT,
            "horizontal %.2f m, vertical %.2f m",
            now.raw().horizontalAccuracy(),
            orZero(now.raw().verticalAccuracy()));
  }

  /**
   * {@inheritDoc} It may have the mode NONE while the receiver has just lost its satellites.
   *
   * @throws NotReadyException if none has been received yet, or the last one has expired
   */
  @Override
  public GpsFix fix() {
    return latest().get().fix();
  }

  /**
   * {@inheritDoc} The frame is the receiver's antenna, {@code robot/name}.
   *
   * @throws NotReadyException as {@link #fix}
   */
  @Override
  public LocationReading location() {
    return latest().get().location();
  }

  /**
   * {@inheritDoc}
   *
   * @throws NotReadyException as {@link #fix}, and while the date is unknown
   */
  @Override
  public TimeReading time() {
    @Nullable TimeReading time = latest().get().time();
    if (time == null) {
      throw new NotReadyException(
          path(), readiness(), "it has positions, but the autopilot does not know the date yet");
    }
    return time;
  }

  @Override
  protected List<? extends Attributes> deviceAttributes() {
    return attributes.all(RECEIVER);
  }
}
