package org.dfra.drivers.gps.nmea;

import java.time.Instant;
import java.time.InstantSource;
import java.time.LocalTime;
import java.util.List;
import java.util.function.Consumer;
import org.dfra.drivers.gps.GpsReceiverProtocol.GpsSolution;
import org.dfra.drivers.gps.GpsReceiverProtocol.SatelliteInView;
import org.dfra.drivers.gps.nmea.NmeaSentence.Gga;
import org.dfra.drivers.gps.nmea.NmeaSentence.Gns;
import org.dfra.drivers.gps.nmea.NmeaSentence.Gsa;
import org.dfra.drivers.gps.nmea.NmeaSentence.Gsv;
import org.dfra.drivers.gps.nmea.NmeaSentence.Rmc;
import org.dfra.drivers.gps.nmea.NmeaSentence.Vtg;
import org.dfra.drivers.gps.nmea.NmeaSentence.Zda;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;

/**
 * Combines the sentences of one epoch. {@code RMC} has date, speed and course, {@code GGA} or
 * {@code GNS} height and quality, {@code GSA} the dimensions, {@code VTG} speed and course, {@code
 * ZDA} the date; no sentence marks the end of its epoch.
 *
 * <p>A solution is published as soon as both {@code RMC} and {@code GGA} (or {@code GNS}) of an
 * epoch have been received, or the one of them that the receiver sends; an incomplete solution is
 * published when the next epoch begins. The last {@code GSA} and {@code GSV} are used, which may
 * belong to the previous epoch, and the speed and course of the last 2 s, see {@link NmeaMotion}.
 *
 * <p>Confined to one thread.
 */
final class NmeaEpochAssembler {

  /**
   * A receiver that has sent three {@code GGA} without a {@code RMC} sends none, and vice versa.
   */
  private static final int PATIENCE = 2;

  private final InstantSource clock;
  private final Consumer<GpsSolution> solutions;
  private final NmeaSatelliteTracker sky = new NmeaSatelliteTracker();
  private final NmeaMotion motion = new NmeaMotion();
  private final NmeaDateResolver calendar = new NmeaDateResolver();
  private List<SatelliteInView> satellites = List.of();

  private @Nullable LocalTime time;
  private @Nullable Rmc rmc;
  private @Nullable Gga gga;
  private boolean published;
  private int withoutRmc;
  private int withoutGga;
  private @Nullable Gsa gsa;

  /**
   * @param clock gives the date while the receiver has not reported one
   * @param solutions receives every solution
   */
  NmeaEpochAssembler(InstantSource clock, Consumer<GpsSolution> solutions) {
    this.clock = clock;
    this.solutions = solutions;
  }

  /** Resets the state: another stream begins. */
  void forget() {
    time = null;
    rmc = null;
    gga = null;
    published = true;
    withoutRmc = 0;
    withoutGga = 0;
    gsa = null;
    motion.forget();
    calendar.forget();
    satellites = List.of();
  }

  /** The known satellites in view. */
  List<SatelliteInView> satellites() {
    return satellites;
  }

  /** Processes a sentence; true when the satellites may have changed. */
  boolean take(NmeaSentence sentence) {
    if (sentence instanceof Rmc next) {
      beginEpoch(next.time());
      rmc = next;
      calendar.update(next.date(), next.time());
      motion.take(next);
      withoutRmc = 0;
      withoutGga++;
      publishIfComplete();
    } else if (sentence instanceof Gga next) {
      take(next);
    } else if (sentence instanceof Gns next && !next.modes().isEmpty()) {
      takeUnlessGiven(next);
    } else if (sentence instanceof Vtg next) {
      motion.take(next, time);
    } else if (sentence instanceof Zda next) {
      calendar.update(next.date(), next.time());
    } else if (sentence instanceof Gsa next) {
      gsa = next;
      sky.take(next);
    } else if (sentence instanceof Gsv next && sky.take(next)) {
      satellites = sky.all();
      return true;
    }
    return false;
  }

  private void take(Gga next) {
    beginEpoch(next.time());
    gga = next;
    withoutGga = 0;
    withoutRmc++;
    publishIfComplete();
  }

  /** Some receivers send both; the first of an epoch is used. */
  private void takeUnlessGiven(Gns next) {
    boolean given = gga != null && next.time() != null && next.time().equals(time);
    if (!given) {
      take(next.toGga());
    }
  }

  private void beginEpoch(@Nullable LocalTime next) {
    boolean same = next != null && next.equals(time);
    // RMC and GGA may both have no time; then they belong to the same epoch.
    boolean sameUnknown = next == null && time == null && (rmc == null) != (gga == null);
    if (same || sameUnknown) {
      return;
    }
    if (!published) {
      publish();
    }
    time = next;
    rmc = null;
    gga = null;
    published = false;
    motion.expire(next);
    sky.nextEpoch();
  }

  private void publishIfComplete() {
    boolean complete =
        (rmc != null || withoutRmc > PATIENCE) && (gga != null || withoutGga > PATIENCE);
    if (complete && !published) {
      publish();
    }
  }

  private void publish() {
    if (rmc == null && gga == null) {
      return;
    }
    published = true;
    GpsFix.Mode mode = mode();
    boolean none = mode == GpsFix.Mode.NONE;
    int trackedCount = (int) satellites.stream().filter(SatelliteInView::isTracked).count();
    int tracked = Math.max(trackedCount, gga == null ? 0 : gga.used());
    solutions.accept(
        new GpsSolution(
            new GpsFix(
                mode,
                none ? null : position(),
                utc(),
                none ? Double.NaN : motion.speed(),
                none ? Double.NaN : motion.course(),
                dilution(mode),
                Math.max(satellites.size(), tracked),
                tracked),
            utcUnconfirmedReason(),
            (none ? "searching for satellites, " : "giving a fix, ")
                + tracked
                + " of "
                + Math.max(satellites.size(), tracked)
                + " tracked"));
  }

  private GpsFix.Mode mode() {
    boolean estimated = rmc != null && !rmc.valid();
    if (estimated || Double.isNaN(latitude()) || Double.isNaN(longitude())) {
      return GpsFix.Mode.NONE;
    }
    if (gga != null) {
      return switch (gga.quality()) {
        case 0, 6 -> GpsFix.Mode.NONE; // "estimated" is what the M12+ calls "propagated"
        case 7 -> GpsFix.Mode.POSITION_HOLD;
        default -> dimensions();
      };
    }
    return switch (rmc == null ? 'N' : rmc.mode()) {
      case 'N', 'E' -> GpsFix.Mode.NONE;
      case 'M' -> GpsFix.Mode.POSITION_HOLD;
      default -> GpsFix.Mode.FIX_2D;
    };
  }

  /** Without a height above the ellipsoid a fix is not 3-D, whatever the receiver reports. */
  private GpsFix.Mode dimensions() {
    boolean flat = gsa != null && gsa.dimensions() == 2;
    return flat || Double.isNaN(height()) ? GpsFix.Mode.FIX_2D : GpsFix.Mode.FIX_3D;
  }

  private GeoPosition position() {
    double height = height();
    return new GeoPosition(latitude(), longitude(), Double.isNaN(height) ? 0 : height);
  }

  private double latitude() {
    return gga != null ? gga.latitude() : rmc != null ? rmc.latitude() : Double.NaN;
  }

  private double longitude() {
    return gga != null ? gga.longitude() : rmc != null ? rmc.longitude() : Double.NaN;
  }

  private double height() {
    return gga == null ? Double.NaN : gga.altitude() + gga.separation();
  }

  private double dilution(GpsFix.Mode mode) {
    double pdop = gsa == null ? Double.NaN : gsa.pdop();
    double hdop = gga == null ? Double.NaN : gga.dilution();
    double required = mode == GpsFix.Mode.FIX_3D && !Double.isNaN(pdop) ? pdop : hdop;
    return mode == GpsFix.Mode.NONE || Double.isNaN(required) ? 0 : required;
  }

  private Instant utc() {
    LocalTime at = time;
    return at == null ? clock.instant() : calendar.resolve(at, clock.instant());
  }

  private @Nullable String utcUnconfirmedReason() {
    if (time == null) {
      return "has not reported the time yet";
    }
    return calendar.isKnown() ? null : "has not reported the date yet, which only RMC and ZDA do";
  }
}
