package org.dfra.benchmarks.micro;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.PriorityQueue;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dfra.behaviors.perceptual.mines.ImageMineDetector.ImageDetections;
import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
import org.dfra.benchmarks.attack.CallBytes;
import org.dfra.drivers.gps.m12.M12Message;
import org.dfra.drivers.gps.m12.M12Message.MalformedMessage;
import org.dfra.drivers.gps.m12.M12Parser;
import org.dfra.drivers.gps.nmea.NmeaParser;
import org.dfra.drivers.gps.nmea.NmeaSentence;
import org.dfra.event.Delivery;
import org.dfra.flow.motor.DriveAdvice;
import org.dfra.flow.sensor.CameraImage.Band;
import org.dfra.river.remote.RemoteModuleListener;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.openjdk.jmh.annotations.Benchmark;

/** What is measured is right: each benchmark method runs here once or twice, without a clock. */
@Timeout(60)
class MicroBenchmarkTest {

  @Test
  void listsEveryMethodThatJmhKnows() throws IOException {
    List<String> annotated =
        MicroBenchmark.ALL.stream()
            .map(MicroBenchmark::type)
            .distinct()
            .flatMap(
                type ->
                    Stream.of(type.getMethods())
                        .filter(method -> method.isAnnotationPresent(Benchmark.class))
                        .map(method -> type.getName() + "." + method.getName()))
            .toList();
    assertThat(MicroBenchmark.ALL)
        .extracting(MicroBenchmark::name)
        .doesNotHaveDuplicates()
        .containsExactlyInAnyOrderElementsOf(annotated);
    assertThat(MicroBenchmark.ALL).extracting(MicroBenchmark::title).doesNotHaveDuplicates();
    try (InputStream list = MicroBenchmark.class.getResourceAsStream("/META-INF/BenchmarkList")) {
      assertThat(list).as("written by JMH's annotation processor in either build").isNotNull();
      String generated = new String(list.readAllBytes(), StandardCharsets.UTF_8);
      assertThat(MicroBenchmark.ALL)
          .allSatisfy(
              each ->
                  assertThat(generated)
                      .contains(each.type().getName())
                      .contains(" " + each.method() + " "));
    }
  }

  @Test
  void choosesByTitleOrId() {
    assertThat(MicroBenchmark.matching(null)).isEqualTo(MicroBenchmark.ALL);
    assertThat(MicroBenchmark.matching(Pattern.compile("361")))
        .extracting(MicroBenchmark::id)
        .containsExactly("CallBenchmark.scan", "CallBenchmark.scanPlain");
    assertThat(MicroBenchmark.matching(Pattern.compile("^FuzzyStep"))).hasSize(2);
    assertThat(MicroBenchmark.matching(Pattern.compile("nothing"))).isEmpty();
  }

  @Test
  void eachVariantIsComparedWithTheOperationItself() {
    for (MicroBenchmark each : MicroBenchmark.ALL) {
      if (!each.variant().isEmpty()) {
        assertThat(MicroBenchmark.ALL)
            .filteredOn(other -> other.peer().filter(each::equals).isPresent())
            .as(each.title())
            .extracting(MicroBenchmark::operation)
            .containsExactly(each.operation());
      }
    }
  }

  @Test
  void bothCallsReturnTheSameOverTheLoopback() throws Exception {
    CallBenchmark calls = new CallBenchmark();
    calls.start();
    try {
      assertThat(calls.range()).isEqualTo(calls.rangePlain()).isBetween(2.0, 12.0);
      assertThat(calls.scan()).hasSize(361).isEqualTo(calls.scanPlain());
      assertThat(calls.scan()).as("a copy: it came by the network").isNotSameAs(calls.scan());
    } finally {
      calls.close();
    }
    assertThatThrownBy(calls::range).isInstanceOf(IOException.class);
  }

  @Test
  void whatIsWrittenIsReadAgain() throws Exception {
    MarshallingBenchmark streams = new MarshallingBenchmark();
    assertThat(streams.readEvent())
        .isEqualTo(MarshallingBenchmark.EVENT)
        .isNotSameAs(MarshallingBenchmark.EVENT);
    assertThat(streams.readEventPlain()).isEqualTo(MarshallingBenchmark.EVENT);
    assertThat(streams.readEventChecked()).isEqualTo(MarshallingBenchmark.EVENT);
    assertThat(streams.readEventUnchecked()).isEqualTo(MarshallingBenchmark.EVENT);
    assertThat(streams.readPercept()).isEqualTo(MarshallingBenchmark.PERCEPT);
    assertThat(streams.readPerceptPlain()).isEqualTo(MarshallingBenchmark.PERCEPT);
    assertThat(streams.writeEvent().length).isGreaterThan(streams.writeEventPlain().length);
    assertThat(streams.writePercept().length).isGreaterThan(streams.writePerceptPlain().length);
  }

  /** Else the benchmark would measure reading without the filter of a call. */
  @Test
  void theReaderOfArgumentsRefusesWhatACallRefuses() throws Exception {
    ArgumentReader reader =
        new ArgumentReader(
            RemoteModuleListener.class.getMethod("notify", Delivery.class),
            (RemoteModuleListener) delivery -> {});
    byte[] forged =
        CallBytes.with(
            RemoteModuleListener.class.getMethod("notify", Delivery.class),
            out -> out.writeObject(new PriorityQueue<>(List.of("no event"))));
    assertThatThrownBy(() -> reader.read(forged, 2)).isInstanceOf(IOException.class);
  }

  @Test
  void theStepIsThatOfTheInference() {
    FuzzyStepBenchmark fuzzy = new FuzzyStepBenchmark();
    FuzzyStepBenchmark same = new FuzzyStepBenchmark();
    fuzzy.start();
    try {
      for (int i = 0; i < 100; i++) {
        DriveAdvice advice = fuzzy.step();
        double[] expected = same.inference();
        double speed = Math.max(0, Math.min(1, expected[0])) * 0.7; // the default max_speed
        double yawRate = Math.max(-1, Math.min(1, expected[1]));
        assertThat(advice.velocity().speed()).isCloseTo(speed, within(1e-9));
        assertThat(advice.velocity().yawRate()).isCloseTo(yawRate, within(1e-9));
        assertThat(advice.reason()).contains("heading_error is");
        assertThat(advice.strength()).isBetween(0.5, 1.0);
      }
    } finally {
      fuzzy.close();
    }
  }

  @Test
  void theParsersDecodeFiveMinutesWithoutDamage() {
    List<M12Message> motorola = M12Parser.parse(DeviceRecording.m12());
    List<NmeaSentence> nmea = NmeaParser.parse(DeviceRecording.nmea());
    assertThat(motorola)
        .as("position and time, 300 times each, and the answers to commands")
        .hasSizeBetween(600, 1000)
        .noneMatch(MalformedMessage.class::isInstance);
    assertThat(nmea)
        .as("several sentences a second")
        .hasSizeBetween(900, 3000)
        .noneMatch(NmeaSentence.Malformed.class::isInstance);
    ParserBenchmark parsers = new ParserBenchmark();
    assertThat(parsers.motorola()).isEqualTo(motorola.size());
    assertThat(parsers.motorola()).as("of the second time too").isEqualTo(2L * motorola.size());
    assertThat(parsers.nmea() - 2L * motorola.size()).isEqualTo(nmea.size());
  }

  @Test
  void theSearchFindsTheMines() throws IOException {
    TemplateMatchBenchmark search = new TemplateMatchBenchmark();
    for (Band band : Band.values()) {
      List<MineLane.LabelledImage> images = search.images(band);
      int shown = 0;
      int found = 0;
      for (int i = 1; i <= images.size(); i++) {
        ImageDetections detections = band == Band.VISIBLE ? search.light() : search.heat();
        for (GroundPoint mine : images.get(i % images.size()).mines()) {
          if (mine.x() > 1.3 && mine.x() < 2.8 && Math.abs(mine.y()) < 0.6) {
            shown++;
            if (detections.points().stream().anyMatch(each -> each.distance(mine) < 0.2)) {
              found++;
            }
          }
        }
      }
      assertThat(shown).as("mines in good view, of all images").isGreaterThanOrEqualTo(4);
      assertThat(found).as("found within 0.2 m, %s", band).isGreaterThanOrEqualTo(shown * 3 / 4);
    }
    assertThat(search.lightDecoded().getWidth()).isEqualTo(320);
    assertThat(search.heatDecoded().getHeight()).isEqualTo(240);
    assertThat(search.heatDecoded().getRaster().getNumBands()).isEqualTo(1);
  }
}
