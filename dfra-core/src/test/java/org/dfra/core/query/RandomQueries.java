package org.dfra.core.query;

import java.lang.reflect.RecordComponent;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dfra.directory.Condition;
import org.dfra.directory.ModuleQuery;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Module;
import org.dfra.persona.Attributes;

/** Every query there is, sooner or later. */
final class RandomQueries {

  /** A record with a component of each type that a query may ask for. */
  record EverythingAttributes(
      int whole,
      long large,
      double real,
      float small,
      Double boxed,
      boolean flag,
      Readiness state,
      Instant when,
      String text,
      List<String> texts)
      implements Attributes {}

  static final QueryTypeNames VOCABULARY =
      QueryTypeNames.standard().with(List.of(EverythingAttributes.class));

  private static final String CHARACTERS =
      "abcXYZ019_-./ \"\\'=<>≥≤,[]°!\t\näßé−and within to of m 3D";

  private final Random random;
  private final List<Class<? extends Module>> kinds = new ArrayList<>(VOCABULARY.kinds());
  private final List<Class<? extends Attributes>> attributes =
      new ArrayList<>(VOCABULARY.attributes());

  RandomQueries(long seed) {
    random = new Random(seed);
  }

  ModuleQuery<? extends Module> next() {
    ModuleQuery<? extends Module> query = ModuleQuery.of(any(kinds));
    if (random.nextBoolean()) {
      query = query.name(text());
    }
    if (random.nextBoolean()) {
      query = query.robot(text());
    }
    for (int tests = random.nextInt(4); tests > 0; tests--) {
      Class<? extends Attributes> type = any(attributes);
      RecordComponent component = any(List.of(type.getRecordComponents()));
      query = query.where(type, component.getName(), condition(component.getType()));
    }
    if (random.nextInt(3) == 0) {
      query =
          query.within(
              Math.abs(number()) % 1e9,
              new GeoPosition(
                  random.nextDouble() * 180 - 90, random.nextDouble() * 360 - 180, number() % 1e4));
    }
    return query;
  }

  private Condition condition(Class<?> type) {
    if (type == String.class) {
      return random.nextBoolean() ? Condition.contains(text()) : Condition.equalTo(text());
    } else if (type == List.class) {
      return random.nextBoolean()
          ? Condition.contains(text())
          : Condition.equalTo(List.of(text(), text()).subList(0, random.nextInt(3)));
    } else if (type == boolean.class) {
      return Condition.equalTo(random.nextBoolean());
    } else if (type.isEnum()) {
      return Condition.equalTo(any(List.of((Enum<?>[]) type.getEnumConstants())));
    } else if (type == Instant.class) {
      return Condition.equalTo(Instant.ofEpochMilli(random.nextInt()));
    }
    double one = number();
    double other = number();
    return switch (random.nextInt(6)) {
      case 0 -> Condition.atLeast(one);
      case 1 -> Condition.atMost(one);
      case 2 -> Condition.between(Math.min(one, other), Math.max(one, other));
      case 3 -> Condition.equalTo(random.nextInt());
      case 4 -> Condition.equalTo(random.nextLong());
      default -> Condition.equalTo(one);
    };
  }

  private double number() {
    return switch (random.nextInt(6)) {
      case 0 -> random.nextInt(100);
      case 1 -> -random.nextDouble();
      case 2 -> Double.longBitsToDouble(random.nextLong() & 0x7fe0_0000_0000_ffffL);
      default -> random.nextGaussian() * 1000;
    };
  }

  private String text() {
    if (random.nextBoolean()) {
      return any(List.of("atrv1", "gps_front", "on", "and", "within", "a b", "", "\"", "\\"));
    }
    StringBuilder text = new StringBuilder();
    for (int length = random.nextInt(12); length > 0; length--) {
      text.append(CHARACTERS.charAt(random.nextInt(CHARACTERS.length())));
    }
    return text.toString();
  }

  private <T> T any(List<T> list) {
    return list.get(random.nextInt(list.size()));
  }
}
