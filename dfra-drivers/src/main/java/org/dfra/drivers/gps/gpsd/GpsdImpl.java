package org.dfra.drivers.gps.gpsd;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.GpsReceiverImpl;
import org.dfra.drivers.gps.GpsReceiverProtocol;
import org.dfra.drivers.gps.GpsReceiverProtocol.GpsSolution;
import org.dfra.drivers.gps.GpsReceiverProtocol.SatelliteInView;
import org.dfra.drivers.gps.GpsReceiverType;
import org.dfra.drivers.gps.ReportingPeriod.FixedReportingPeriod;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Device;
import org.dfra.drivers.gps.gpsd.GpsdMessage.Tpv;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.persona.GpsReceiverAttributes;
import org.jspecify.annotations.Nullable;

/**
 * A receiver served by gpsd, at {@code tcp://host:2947}.
 *
 * <p>Parameters, besides those of every {@link GpsReceiverImpl}:
 *
 * <ul>
 *   <li>{@code device}: which of gpsd's receivers, by its path, e.g. {@code /dev/ttyUSB0}; by
 *       default all of them, which is correct for one receiver
 *   <li>{@code period}: seconds from one position to the next, as configured in the receiver;
 *       default 1
 * </ul>
 *
 * <p>A 3-D fix needs the height above the ellipsoid ({@code altHAE}), which gpsd reports since
 * version 3.20. Test, besides: {@code identification}, gpsd answers {@code ?VERSION} within 3 s.
 */
public final class GpsdImpl extends GpsReceiverImpl<GpsdImpl.Protocol> {

  private static final GpsReceiverType KIND =
      GpsReceiverType.of(
          "receiver behind gpsd", 1.0 / 3600, 50, List.of(GpsReceiverType.SATELLITES));

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public GpsdImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /** For tests: uses the given clock and source of links. */
  GpsdImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    super(
        context,
        KIND,
        FixedReportingPeriod.from(context.parameters()),
        listener -> new Protocol(context, listener),
        ticker,
        source);
    diagnostics()
        .addTest(
            "identification",
            () ->
                receiverDiagnostics()
                    .ask(
                        bytes("?VERSION;"),
                        "VERSION",
                        "?VERSION",
                        () -> "it says it is gpsd " + protocol().release));
  }

  private static byte[] bytes(String command) {
    return (command + "\r\n").getBytes(StandardCharsets.UTF_8);
  }

  /** Requests gpsd's reports and processes them. */
  static final class Protocol implements GpsReceiverProtocol {

    private static final String SYSTEMS = "GSEC?JRI";

    private final ModuleContext context;
    private final Listener listener;
    private final String device;
    private final GpsdParser parser = new GpsdParser(this::messageReceived);

    private volatile String release = ""; // read by any thread
    private List<SatelliteInView> satellites = List.of();
    private double pdop = Double.NaN;
    private double hdop = Double.NaN;

    Protocol(ModuleContext context, Listener listener) {
      this.context = context;
      this.listener = listener;
      this.device = deviceIn(context.parameters());
    }

    /** Reads the device's path and checks that it needs no escapes in a command. */
    private static String deviceIn(Parameters parameters) {
      if (parameters.find("device").isEmpty()) {
        return "";
      }
      String path = parameters.text("device");
      if (path.isBlank() || path.matches("(?s).*[\"\\\\\\p{Cntrl}].*")) {
        throw parameters.fault("device", "the path of a device", null);
      }
      return path;
    }

    @Override
    public void opened(SerialLink link) throws IOException {
      satellites = List.of();
      pdop = Double.NaN;
      hdop = Double.NaN;
      String which = device.isEmpty() ? "" : ",\"device\":\"" + device + "\"";
      link.write(bytes("?WATCH={\"enable\":true,\"json\":true" + which + "};"));
    }

    @Override
    public GpsdParser parser() {
      return parser;
    }

    private void messageReceived(GpsdMessage message) {
      if (message instanceof Tpv tpv) {
        if (device.isEmpty() || tpv.device().isEmpty() || tpv.device().equals(device)) {
          listener.solutionReceived(solution(tpv));
        }
      } else if (message instanceof GpsdMessage.Sky sky) {
        take(sky);
      } else if (message instanceof GpsdMessage.Version version) {
        release = version.release();
        identify("", "");
      } else if (message instanceof Device reported) {
        identify(reported);
      } else if (message instanceof GpsdMessage.Devices all) {
        all.devices().forEach(this::identify);
      } else if (message instanceof GpsdMessage.Malformed malformed) {
        listener.malformedReceived(malformed.name(), malformed.reason());
      }
      listener.messageReceived(message.name());
    }

    private void identify(Device reported) {
      if (device.isEmpty() || reported.path().equals(device)) {
        identify(reported.driver(), reported.subtype());
      }
    }

    private void identify(String driver, String subtype) {
      String model = (driver + " " + subtype).strip();
      listener.identityReceived(
          new GpsReceiverAttributes(
              model.isEmpty() ? null : model,
              null,
              "gpsd",
              release.isEmpty() ? null : release,
              null,
              List.of("2D", "3D")));
    }

    private void take(GpsdMessage.Sky sky) {
      pdop = Double.isNaN(sky.pdop()) ? pdop : sky.pdop();
      hdop = Double.isNaN(sky.hdop()) ? hdop : sky.hdop();
      List<GpsdMessage.Satellite> reported = sky.satellites();
      if (reported != null) {
        List<SatelliteInView> all = new ArrayList<>();
        reported.forEach(satellite -> all.add(inView(satellite)));
        satellites = List.copyOf(all);
        listener.satellitesReceived(satellites);
      }
    }

    private GpsSolution solution(Tpv reported) {
      GpsFix.Mode mode = mode(reported);
      boolean none = mode == GpsFix.Mode.NONE;
      double dilution = mode == GpsFix.Mode.FIX_3D ? pdop : hdop;
      int received = (int) satellites.stream().filter(SatelliteInView::isTracked).count();
      return new GpsSolution(
          new GpsFix(
              mode,
              none
                  ? null
                  : new GeoPosition(
                      reported.latitude(), reported.longitude(), orZero(reported.height())),
              reported.time() == null ? context.clock().instant() : reported.time(),
              reported.speed(),
              reported.track(),
              none ? 0 : orZero(dilution),
              satellites.size(),
              received),
          reported.time() == null ? "gpsd has not reported the time yet" : null,
          (none ? "searching for satellites, " : "giving a fix, ")
              + received
              + " of "
              + satellites.size()
              + " tracked",
          reported.horizontalError(),
          reported.verticalError());
    }

    private static GpsFix.Mode mode(Tpv reported) {
      boolean placed = !Double.isNaN(reported.latitude()) && !Double.isNaN(reported.longitude());
      if (reported.mode() < 2 || reported.status() == 5 || !placed) { // 5 is dead reckoning alone
        return GpsFix.Mode.NONE;
      }
      if (reported.status() == 7) {
        return GpsFix.Mode.POSITION_HOLD;
      }
      return reported.mode() == 2 || Double.isNaN(reported.height())
          ? GpsFix.Mode.FIX_2D
          : GpsFix.Mode.FIX_3D;
    }

    private static double orZero(double number) {
      return Double.isNaN(number) ? 0 : number;
    }

    private static SatelliteInView inView(GpsdMessage.Satellite reported) {
      return new SatelliteInView(
          name(reported),
          Double.isNaN(reported.elevation()) ? null : (int) Math.round(reported.elevation()),
          Double.isNaN(reported.azimuth()) ? null : (int) Math.round(reported.azimuth()),
          !(reported.signal() > 0) ? null : (int) Math.round(reported.signal()),
          reported.used());
    }

    private static String name(GpsdMessage.Satellite reported) {
      if (reported.system() >= 0 && reported.system() < SYSTEMS.length() && reported.number() > 0) {
        char system = SYSTEMS.charAt(reported.system());
        int number =
            system == 'S' && reported.number() > 100 ? reported.number() - 100 : reported.number();
        return String.format(Locale.ROOT, "%c%02d", system, number);
      }
      int prn = reported.prn(); // from its number range, as in NMEA
      if (prn > 64 && prn <= 96) {
        return String.format(Locale.ROOT, "R%02d", prn - 64);
      }
      return prn >= 120 && prn <= 158
          ? String.format(Locale.ROOT, "S%02d", prn - 100)
          : String.format(Locale.ROOT, "G%02d", Math.max(0, prn));
    }
  }
}
