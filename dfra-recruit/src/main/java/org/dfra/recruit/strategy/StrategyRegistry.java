package org.dfra.recruit.strategy;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.Optional;
import java.util.random.RandomGenerator;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.NearestName;
import org.dfra.recruit.affect.Affect;
import org.jspecify.annotations.Nullable;

/**
 * The strategies by name: those of the project by a word, any other by its class, {@code
 * org.example.Courteous}. Such a class is public, and has a public constructor with no parameters,
 * or with a {@link RandomGenerator} where chance plays a part in it.
 */
public final class StrategyRegistry {

  /** Those of the project. */
  public static final List<String> NAMES =
      List.of(Affective.NAME, Greedy.NAME, RandomPick.NAME, ContractNet.NAME);

  private StrategyRegistry() {}

  /**
   * One of them, for one agent.
   *
   * @param name a word, or the name of a class
   * @param affect of the affective one
   * @param random of those by chance
   * @throws ConfigurationException if there is none of that name; the message names those there are
   */
  public static RecruitmentStrategy named(String name, Affect affect, RandomGenerator random) {
    return named(name, affect, random, RandomPick.DEFAULT_OFFER_PROBABILITY);
  }

  /**
   * One of them, for one agent.
   *
   * @param name a word, or the name of a class
   * @param affect of the affective one
   * @param random of those by chance
   * @param offerProbability that a free robot offers where it does by lot, above 0 and at most 1; a
   *     class from elsewhere has its own
   * @throws ConfigurationException if there is none of that name; the message names those there are
   */
  public static RecruitmentStrategy named(
      String name, Affect affect, RandomGenerator random, double offerProbability) {
    return switch (name) {
      case Affective.NAME -> new Affective(affect);
      case Greedy.NAME -> new Greedy();
      case RandomPick.NAME -> new RandomPick(random, offerProbability);
      case ContractNet.NAME -> new ContractNet();
      default -> ofClass(type(name), random);
    };
  }

  private static Class<?> type(String name) {
    if (!name.contains(".")) {
      throw new ConfigurationException(
          "there is no strategy \""
              + name
              + "\""
              + NearestName.hint(
                  name,
                  NAMES,
                  "; there are " + String.join(", ", NAMES) + ", and classes by their full names"));
    }
    Class<?> type;
    try {
      type = Class.forName(name, true, Thread.currentThread().getContextClassLoader());
    } catch (ClassNotFoundException e) {
      throw fault(name, "is not on the class path; add its jar or mend the name", e);
    } catch (LinkageError e) {
      throw fault(name, "cannot be loaded (" + e + "); add the jar that it needs", e);
    }
    if (!RecruitmentStrategy.class.isAssignableFrom(type)) {
      throw fault(name, "does not implement " + RecruitmentStrategy.class.getName(), null);
    }
    return type;
  }

  private static RecruitmentStrategy ofClass(Class<?> type, RandomGenerator lot) {
    try {
      Optional<Constructor<?>> byChance = constructor(type, RandomGenerator.class);
      if (byChance.isPresent()) {
        return (RecruitmentStrategy) byChance.get().newInstance(lot);
      }
      Optional<Constructor<?>> plain = constructor(type);
      if (plain.isPresent()) {
        return (RecruitmentStrategy) plain.get().newInstance();
      }
    } catch (InvocationTargetException e) {
      throw fault(type.getName(), "cannot be made: " + e.getCause(), e);
    } catch (ReflectiveOperationException e) {
      throw fault(type.getName(), "cannot be made: " + e, e);
    }
    throw fault(
        type.getName(), "has no public constructor () or (RandomGenerator); give it one", null);
  }

  private static Optional<Constructor<?>> constructor(Class<?> type, Class<?>... parameters) {
    for (Constructor<?> each : type.getConstructors()) {
      if (List.of(each.getParameterTypes()).equals(List.of(parameters))) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }

  private static ConfigurationException fault(String name, String what, @Nullable Throwable cause) {
    String message = "strategy class " + name + " " + what;
    return cause == null
        ? new ConfigurationException(message)
        : new ConfigurationException(message, cause);
  }
}
