package org.dfra.examples.devices;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.UUID;
import java.util.function.Function;
import org.dfra.directory.Locality;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.event.Subscription;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Module;
import org.dfra.persona.ModuleAttributes;
import org.dfra.report.measurement.MeasuredValue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The report of devices that published nothing: its head does not depend on them. */
class DevicesReportTest {

  /** Verdict, date and targets are the first of a report. */
  private static final String REPORT_HEAD =
      "</h1>\\s*<p class=\"verdict (met|missed)\">[^<]+</p>"
          + "\\s*<p>[-\\d]+ [:\\d]+\\sUTC</p>\\s*<table>";

  private static final Instant BEGIN = Instant.parse("2026-11-22T00:00:00Z");

  @TempDir Path folder;

  private static <T> T fake(Class<T> type, Function<Object[], Object> answer) {
    return type.cast(
        Proxy.newProxyInstance(
            DevicesReportTest.class.getClassLoader(),
            new Class<?>[] {type},
            (self, method, arguments) -> answer.apply(arguments)));
  }

  /** A device that works; its subscription has lost nothing. */
  private static <M extends Module> List<ModuleListing<M>> device(Class<M> kind) {
    Subscription subscription = fake(Subscription.class, arguments -> 0L);
    String name = kind.getSimpleName();
    return List.of(
        new ModuleListing<>(
            UUID.randomUUID(),
            fake(kind, arguments -> subscription),
            "atrv1",
            name,
            List.of(
                new ModuleAttributes(
                    "atrv1", name, "D", "host", "me", "1", Readiness.READY, BEGIN, null, 0)),
            Locality.REMOTE,
            false,
            BEGIN));
  }

  @Test
  void verdictDateAndTargetsStandFirst() throws Exception {
    Path truth = Files.writeString(folder.resolve("in.csv"), BEGIN + ",atrv1,0,0,0,0,0,0,0\n");
    ModuleDirectory directory =
        fake(ModuleDirectory.class, arguments -> device(((ModuleQuery<?>) arguments[0]).kind()));
    DeviceRecorders recorders =
        new DeviceRecorders(new RobotDevices(directory), new GeoPosition(48, 11, 0), BEGIN);
    DevicesReport report =
        new DevicesReport(
            recorders, GroundTruthTrack.read(truth, "atrv1", BEGIN), BEGIN, BEGIN.plusSeconds(20));
    List<MeasuredValue> measured = List.of(new MeasuredValue("drive back", 1, 5, "s"));
    String html =
        Files.readString(report.write(folder.resolve("report"), measured, List.of(), truth));
    assertThat(html).containsPattern(REPORT_HEAD);
    assertThat(html).contains("<td>drive back</td>", "Path");
  }
}
