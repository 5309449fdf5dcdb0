package org.dfra.directory;

import static org.dfra.directory.Condition.atLeast;
import static org.dfra.directory.Condition.atMost;
import static org.dfra.directory.Condition.between;
import static org.dfra.directory.Condition.contains;
import static org.dfra.directory.Condition.equalTo;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.UUID;
import java.util.function.Predicate;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.Attributes;
import org.dfra.persona.ChainAttributes;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.LocationAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.SensorAttributes;

/**
 * Many modules and fifty questions about them, each one written twice: as a query and as plain Java
 * over what was listed. Seeded, so every run asks the same.
 */
final class ScriptedQuestions {

  private static final long SEED = 20261121;
  private static final int PER_ROBOT = 50;
  private static final GeoPosition FIELD = new GeoPosition(52.9, 6.8, 10);

  /** One module, with what the brute force looks at. */
  record Listed(
      ListedGps module,
      ModuleAttributes who,
      SensorAttributes sensor,
      GpsReceiverAttributes device,
      LocationAttributes location) {
    List<Attributes> attributes() {
      return List.of(
          who, new ChainAttributes(List.of(), List.of("GpsFix")), sensor, device, location);
    }
  }

  /** One question. */
  record Question(ModuleQuery<GPSSensor> query, Predicate<Listed> truth) {}

  private final List<Listed> listed = new ArrayList<>();
  private final List<Question> questions = new ArrayList<>();

  ScriptedQuestions(int modules) {
    Random random = new Random(SEED);
    for (int i = 0; i < modules; i++) {
      listed.add(module(i, random));
    }
    Random asked = new Random(SEED + 1);
    for (int i = 0; i < 10; i++) {
      questions.addAll(five(asked));
    }
  }

  private static Listed module(int i, Random random) {
    String robot = "robot" + i / PER_ROBOT;
    String name = "gps" + i % PER_ROBOT;
    List<String> modes =
        List.of(List.of("2D"), List.of("2D", "3D"), List.<String>of()).get(random.nextInt(3));
    return new Listed(
        new ListedGps(new UUID(SEED, i), name),
        new ModuleAttributes(
            robot,
            name,
            "org.example.Driver" + random.nextInt(5),
            "127.0.0.1",
            "DFRA",
            "1",
            Readiness.values()[random.nextInt(Readiness.values().length)],
            Instant.EPOCH,
            null,
            random.nextInt(4)),
        new SensorAttributes(
            "GpsFix",
            List.of(),
            random.nextInt(3),
            3 + random.nextInt(50) / 2.0,
            random.nextBoolean() ? null : random.nextDouble(),
            List.of()),
        new GpsReceiverAttributes(
            "M" + random.nextInt(20), null, null, null, 8 + 4 * random.nextInt(2), modes),
        new LocationAttributes(
            FIELD.latitude() + random.nextInt(1000) / 1e5,
            FIELD.longitude() + random.nextInt(1000) / 1e5,
            10,
            Instant.EPOCH));
  }

  private List<Question> five(Random random) {
    ModuleQuery<GPSSensor> any = ModuleQuery.of(GPSSensor.class);
    Listed some = listed.get(random.nextInt(listed.size()));
    double rate = 3 + random.nextInt(50) / 2.0;
    double power = random.nextDouble();
    double metres = 20 + random.nextInt(400);
    String model = "M" + random.nextInt(20);
    GeoPosition there = some.location().position();
    return List.of(
        new Question(
            any.robot(some.who().robot()).where(SensorAttributes.class, "maxRate", atLeast(rate)),
            each ->
                each.who().robot().equals(some.who().robot()) && each.sensor().maxRate() >= rate),
        new Question(
            any.where(GpsReceiverAttributes.class, "fixModes", contains("3D"))
                .where(SensorAttributes.class, "power", atMost(power)),
            each ->
                each.device().fixModes().contains("3D")
                    && each.sensor().power() != null
                    && each.sensor().power() <= power),
        new Question(
            any.where(GpsReceiverAttributes.class, "model", equalTo(model))
                .where(ModuleAttributes.class, "state", equalTo(Readiness.READY)),
            each -> model.equals(each.device().model()) && each.who().state() == Readiness.READY),
        new Question(
            any.within(metres, there),
            each -> each.location().position().groundDistance(there) <= metres),
        new Question(
            any.name(some.who().name())
                .where(SensorAttributes.class, "minRate", between(1, 2))
                .where(GpsReceiverAttributes.class, "channels", equalTo(12)),
            each ->
                each.who().name().equals(some.who().name())
                    && each.sensor().minRate() >= 1
                    && each.sensor().minRate() <= 2
                    && each.device().channels() == 12));
  }

  List<Listed> listed() {
    return listed;
  }

  List<Question> questions() {
    return questions;
  }

  /** What the answer must be. */
  List<UUID> answer(Question question) {
    return listed.stream().filter(question.truth()).map(each -> each.module().id()).toList();
  }
}
