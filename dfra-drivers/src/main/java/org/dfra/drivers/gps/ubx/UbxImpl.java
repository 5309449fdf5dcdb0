package org.dfra.drivers.gps.ubx;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.GpsReceiverImpl;
import org.dfra.drivers.gps.GpsReceiverProtocol;
import org.dfra.drivers.gps.GpsReceiverProtocol.GpsSolution;
import org.dfra.drivers.gps.GpsReceiverProtocol.SatelliteInView;
import org.dfra.drivers.gps.GpsReceiverType;
import org.dfra.drivers.gps.ReportingPeriod.FixedReportingPeriod;
import org.dfra.drivers.gps.ubx.UbxMessage.NavPvt;
import org.dfra.drivers.gps.ubx.UbxMessage.Version;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.Precondition;
import org.dfra.persona.GpsReceiverAttributes;
import org.jspecify.annotations.Nullable;

/**
 * A u-blox receiver with UBX, generations 7 to 9: {@code NAV-PVT}, {@code NAV-SAT}, {@code
 * MON-VER}.
 *
 * <p>When the link is opened, the driver queries the receiver's identification and sets the period
 * ({@code CFG-RATE}) and the messages ({@code CFG-MSG}), in its volatile memory only. If the
 * receiver rejects a setting, the driver logs it and continues; the receiver still works if it was
 * configured with its manufacturer's tool.
 *
 * <p>Parameter, besides those of every {@link GpsReceiverImpl}: {@code period}, seconds from one
 * position to the next, 0.05 to 60; default 1.
 *
 * <p>Test, besides: {@code identification}, the receiver answers {@code MON-VER} within 3 s.
 */
public final class UbxImpl extends GpsReceiverImpl<UbxImpl.Protocol> {

  private static final List<Precondition> PRECONDITIONS =
      List.of(
          new Precondition("temperature of the receiver", -40, 85, "°C"),
          new Precondition("altitude", -1000, 50_000, "m"),
          new Precondition("speed", 0, 500, "m/s"),
          GpsReceiverType.SATELLITES);

  private static final GpsReceiverType KIND =
      GpsReceiverType.of("u-blox receiver, by UBX", 1.0 / 60, 20, PRECONDITIONS);

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public UbxImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /** For tests: uses the given clock and source of links. */
  UbxImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    this(
        context,
        ticker,
        source,
        new FixedReportingPeriod(context.parameters().number("period", 1, 0.05, 60)));
  }

  private UbxImpl(
      ModuleContext context,
      Ticker ticker,
      LinkKeeper.@Nullable Source source,
      FixedReportingPeriod reportingPeriod) {
    super(
        context,
        KIND,
        reportingPeriod,
        listener -> new Protocol(context, reportingPeriod, listener),
        ticker,
        source);
    diagnostics()
        .addTest(
            "identification",
            () ->
                receiverDiagnostics()
                    .ask(
                        UbxCommands.version(),
                        "MON-VER",
                        "MON-VER",
                        () -> "it says it is " + protocol().model()));
  }

  /** Configures the receiver and processes its messages. */
  static final class Protocol implements GpsReceiverProtocol {

    private static final String SYSTEMS = "GSEC?JRI";
    private static final int SKY_EVERY = 5; // solutions; the satellites move slowly

    private final ModuleContext context;
    private final FixedReportingPeriod reportingPeriod;
    private final Listener listener;
    private final UbxParser parser = new UbxParser(this::messageReceived);
    private volatile @Nullable Version version; // read by any thread
    private int visible;

    Protocol(ModuleContext context, FixedReportingPeriod reportingPeriod, Listener listener) {
      this.context = context;
      this.reportingPeriod = reportingPeriod;
      this.listener = listener;
    }

    String model() {
      Version reported = version;
      String model = reported == null ? null : reported.extension("MOD");
      return model == null ? "a u-blox receiver" : model;
    }

    @Override
    public void opened(SerialLink link) throws IOException {
      visible = 0;
      link.write(UbxCommands.version());
      link.write(
          UbxCommands.period(Duration.ofMillis(Math.round(1000 * reportingPeriod.seconds()))));
      link.write(UbxCommands.positions());
      link.write(UbxCommands.satellites(SKY_EVERY));
    }

    @Override
    public UbxParser parser() {
      return parser;
    }

    private void messageReceived(UbxMessage message) {
      if (message instanceof NavPvt position) {
        listener.solutionReceived(solution(position));
      } else if (message instanceof UbxMessage.NavSat sky) {
        List<SatelliteInView> satellites = inView(sky);
        visible = satellites.size();
        listener.satellitesReceived(satellites);
      } else if (message instanceof Version reported) {
        version = reported;
        listener.identityReceived(
            new GpsReceiverAttributes(
                reported.extension("MOD"),
                null,
                null,
                reported.software(),
                null,
                List.of("2D", "3D")));
      } else if (message instanceof UbxMessage.Ack ack && !ack.accepted()) {
        listener.warn(
            String.format(
                Locale.ROOT,
                "the receiver refuses setting %04X; set it up with its maker's tool to send"
                    + " NAV-PVT",
                ack.type()));
      } else if (message instanceof UbxMessage.Malformed malformed) {
        listener.malformedReceived(malformed.name(), malformed.reason());
      }
      listener.messageReceived(message.name());
    }

    private GpsSolution solution(NavPvt reported) {
      GpsFix.Mode mode =
          switch (reported.fixOk() ? reported.fixType() : 0) {
            case 2 -> GpsFix.Mode.FIX_2D;
            case 3, 4 -> GpsFix.Mode.FIX_3D;
            case 5 -> GpsFix.Mode.POSITION_HOLD;
            default -> GpsFix.Mode.NONE;
          };
      boolean none = mode == GpsFix.Mode.NONE;
      return new GpsSolution(
          new GpsFix(
              mode,
              none
                  ? null
                  : new GeoPosition(reported.latitude(), reported.longitude(), reported.height()),
              reported.utc() == null ? context.clock().instant() : reported.utc(),
              reported.groundSpeed(),
              reported.course(),
              none ? 0 : reported.pdop(),
              Math.max(visible, reported.satellites()),
              reported.satellites()),
          reported.utc() != null && reported.resolved()
              ? null
              : "does not know UTC for sure yet; after a cold start that takes up to 12.5 minutes",
          none ? "searching for satellites, " + reported.satellites() + " used" : "giving a fix",
          reported.horizontalAccuracy(),
          reported.verticalAccuracy(),
          reported.utc() != null);
    }

    private static List<SatelliteInView> inView(UbxMessage.NavSat sky) {
      List<SatelliteInView> all = new ArrayList<>();
      for (UbxMessage.Satellite each : sky.satellites()) {
        char system = each.system() < SYSTEMS.length() ? SYSTEMS.charAt(each.system()) : '?';
        int number = system == 'S' ? each.number() - 100 : each.number();
        boolean placed = Math.abs(each.elevation()) <= 90;
        all.add(
            new SatelliteInView(
                String.format(Locale.ROOT, "%c%02d", system, number),
                placed ? each.elevation() : null,
                placed ? each.azimuth() : null,
                each.signal() == 0 ? null : each.signal(),
                each.used()));
      }
      return all;
    }
  }
}
