package org.dfra.drivers.gps.gpsd;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.FixedPace;
import org.dfra.drivers.gps.ReceiverImpl;
import org.dfra.drivers.gps.ReceiverKind;
import org.dfra.drivers.gps.ReceiverProtocol;
import org.dfra.drivers.gps.SatelliteInView;
import org.dfra.drivers.gps.Solution;
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
 * A receiver that gpsd serves, at {@code tcp://host:2947}.
 *
 * <p>Parameters, besides those of every {@link ReceiverImpl}:
 *
 * <ul>
 *   <li>{@code device}: which of gpsd's receivers, by its path, e.g. {@code /dev/ttyUSB0}; by
 *       default all of them, which is right where there is one
 *   <li>{@code period}: seconds from one position to the next, as the receiver is set up; default 1
 * </ul>
 *
 * <p>A 3-D fix needs the height above the ellipsoid ({@code altHAE}), which gpsd tells from version
 * 3.20 on. Test, besides: {@code identification}, gpsd answers {@code ?VERSION} within 3 s.
 */
public final class GpsdImpl extends ReceiverImpl<GpsdImpl.Protocol> {

  private static final ReceiverKind KIND =
      ReceiverKind.of("receiver behind gpsd", 1.0 / 3600, 50, List.of(ReceiverKind.SATELLITES));

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public GpsdImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /** For tests: by another time, and over links made in another way. */
  GpsdImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    super(
        context,
        KIND,
        FixedPace.in(context.parameters()),
        listener -> new Protocol(context, listener),
        ticker,
        source);
    examinations()
        .test(
            "identification",
            () ->
                examination()
                    .ask(
                        bytes("?VERSION;"),
                        "VERSION",
                        "?VERSION",
                        () -> "it says it is gpsd " + protocol().release));
  }

  private static byte[] bytes(String command) {
    return (command + "\r\n").getBytes(StandardCharsets.UTF_8);
  }

  /** Asks gpsd to tell what it hears, and takes it. */
  static final class Protocol implements ReceiverProtocol {

    private static final String SYSTEMS = "GSEC?JRI";

    private final ModuleContext context;
    private final Listener listener;
    private final String device;
    private final GpsdParser parser = new GpsdParser(this::heard);

    private volatile String release = ""; // read by anyone
    private List<SatelliteInView> satellites = List.of();
    private double pdop = Double.NaN;
    private double hdop = Double.NaN;

    Protocol(ModuleContext context, Listener listener) {
      this.context = context;
      this.listener = listener;
      this.device = deviceIn(context.parameters());
    }

    /** Whether the path can stand in a command as it is. */
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

    private void heard(GpsdMessage message) {
      if (message instanceof Tpv tpv) {
        if (device.isEmpty() || tpv.device().isEmpty() || tpv.device().equals(device)) {
          listener.solved(solution(tpv));
        }
      } else if (message instanceof GpsdMessage.Sky sky) {
        take(sky);
      } else if (message instanceof GpsdMessage.Version version) {
        release = version.release();
        identify("", "");
      } else if (message instanceof Device told) {
        identify(told);
      } else if (message instanceof GpsdMessage.Devices all) {
        all.devices().forEach(this::identify);
      } else if (message instanceof GpsdMessage.Malformed malformed) {
        listener.malformed(malformed.name(), malformed.reason());
      }
      listener.heard(message.name());
    }

    private void identify(Device told) {
      if (device.isEmpty() || told.path().equals(device)) {
        identify(told.driver(), told.subtype());
      }
    }

    private void identify(String driver, String subtype) {
      String model = (driver + " " + subtype).strip();
      listener.identified(
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
      List<GpsdMessage.Satellite> told = sky.satellites();
      if (told != null) {
        List<SatelliteInView> all = new ArrayList<>();
        told.forEach(satellite -> all.add(inView(satellite)));
        satellites = List.copyOf(all);
        listener.saw(satellites);
      }
    }

    private Solution solution(Tpv told) {
      GpsFix.Mode mode = mode(told);
      boolean none = mode == GpsFix.Mode.NONE;
      double dilution = mode == GpsFix.Mode.FIX_3D ? pdop : hdop;
      int heard = (int) satellites.stream().filter(SatelliteInView::isTracked).count();
      return new Solution(
          new GpsFix(
              mode,
              none
                  ? null
                  : new GeoPosition(told.latitude(), told.longitude(), orZero(told.height())),
              told.time() == null ? context.clock().instant() : told.time(),
              told.speed(),
              told.track(),
              none ? 0 : orZero(dilution),
              satellites.size(),
              heard),
          told.time() == null ? "gpsd has not told the time yet" : null,
          (none ? "searching for satellites, " : "giving a fix, ")
              + heard
              + " of "
              + satellites.size()
              + " heard",
          told.horizontalError(),
          told.verticalError());
    }

    private static GpsFix.Mode mode(Tpv told) {
      boolean placed = !Double.isNaN(told.latitude()) && !Double.isNaN(told.longitude());
      if (told.mode() < 2 || told.status() == 5 || !placed) { // 5 is dead reckoning alone
        return GpsFix.Mode.NONE;
      }
      if (told.status() == 7) {
        return GpsFix.Mode.POSITION_HOLD;
      }
      return told.mode() == 2 || Double.isNaN(told.height())
          ? GpsFix.Mode.FIX_2D
          : GpsFix.Mode.FIX_3D;
    }

    private static double orZero(double number) {
      return Double.isNaN(number) ? 0 : number;
    }

    private static SatelliteInView inView(GpsdMessage.Satellite told) {
      return new SatelliteInView(
          name(told),
          Double.isNaN(told.elevation()) ? null : (int) Math.round(told.elevation()),
          Double.isNaN(told.azimuth()) ? null : (int) Math.round(told.azimuth()),
          !(told.signal() > 0) ? null : (int) Math.round(told.signal()),
          told.used());
    }

    private static String name(GpsdMessage.Satellite told) {
      if (told.system() >= 0 && told.system() < SYSTEMS.length() && told.number() > 0) {
        char system = SYSTEMS.charAt(told.system());
        int number = system == 'S' && told.number() > 100 ? told.number() - 100 : told.number();
        return String.format(Locale.ROOT, "%c%02d", system, number);
      }
      int prn = told.prn(); // by its range, as in NMEA
      if (prn > 64 && prn <= 96) {
        return String.format(Locale.ROOT, "R%02d", prn - 64);
      }
      return prn >= 120 && prn <= 158
          ? String.format(Locale.ROOT, "S%02d", prn - 100)
          : String.format(Locale.ROOT, "G%02d", Math.max(0, prn));
    }
  }
}
