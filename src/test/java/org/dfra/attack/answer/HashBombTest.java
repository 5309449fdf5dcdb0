package org.dfra.attack.answer;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dfra.attack.kit.Victim;
import org.dfra.benchmarks.attack.RawCall.Answer;
import org.dfra.benchmarks.attack.RawCall.Status;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Arguments that are small to send and for ever to build, because keys are hashed. */
@Timeout(120)
class HashBombTest {

  /** Characters by two, with the same hash code in either order. */
  private static final String[] EQUAL_HASHES = {"Aa", "BB"};

  private OpenBox box;

  @BeforeEach
  void export() throws Exception {
    box = new OpenBox();
    assertThat(box.proxy().put("loads the classes")).isEqualTo(1);
  }

  @AfterEach
  void end() {
    box.close();
  }

  @Test
  void nestedSetsAreRefused() throws Exception {
    assertRefused(nested(20), "hash tables in one another");
  }

  @Test
  void setsThatReferBackToEachOtherAreRefused() throws Exception {
    for (int count : new int[] {60, 3_000}) {
      byte[] call = box.call(ladder(count));
      assertThat(call).as("bytes of the attack").hasSizeLessThan(150_000);
      assertRefused(call, "hash tables in one another");
    }
  }

  @Test
  void aKeyOfListsThatReferBackToEachOtherIsRefused() throws Exception {
    List<Object> top = new ArrayList<>(List.of("x"));
    List<Object> rungs = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      rungs.add(top);
      top = new ArrayList<>(List.of(top, top));
    }
    List<Object> key = new ArrayList<>();
    Set<Object> set = new HashSet<>(Set.of(key));
    key.add(top);
    assertRefused(box.call(new Object[] {rungs, set}), "steps to hash keys");
  }

  @Test
  void collidingKeysAreRefused() throws Exception {
    assertRefused(box.call(colliding(40_000)), "entries of hash tables > ");
    Map<String, Integer> strings = new HashMap<>();
    for (int i = 0; i < 40_000; i++) {
      strings.put(text(i), i);
    }
    assertRefused(box.call(strings), "entries of hash tables > ");
  }

  @Test
  void asManyCollidingKeysAsAreAllowedCostLittle() throws Exception {
    byte[] call = box.call(colliding(1_500));
    Duration before = OpenBox.cpu();
    assertThat(box.send(call).status()).isEqualTo(Status.RETURNED);
    assertThat(OpenBox.cpu().minus(before)).as("CPU time of the call").isLessThan(Victim.CPU);
  }

  /** Where anything is taken, this set would pass: only the method's own types refuse it. */
  @Test
  void aMethodThatTakesATextReadsNoSet() throws Exception {
    Answer answer = box.send(box.labelCall(colliding(1_500)));
    assertThat(answer.status()).as("%s", answer.failure()).isEqualTo(Status.THREW);
    assertThat((Throwable) answer.object())
        .hasStackTraceContaining(
            "refused to read class java.util.HashSet: no argument of Box.label holds one");
    assertThat(box.proxy().label("still serving")).isEqualTo(2);
  }

  private void assertRefused(Object argument, String why) throws Exception {
    assertRefused(box.call(argument), why);
  }

  private void assertRefused(byte[] call, String why) throws Exception {
    Duration before = OpenBox.cpu();
    Answer answer = box.send(call);
    Duration cost = OpenBox.cpu().minus(before);
    assertThat(answer.status()).as("%s", answer.failure()).isEqualTo(Status.THREW);
    assertThat((Throwable) answer.object())
        .hasStackTraceContaining("refused to read on: ")
        .hasStackTraceContaining(why);
    assertThat(cost).as("CPU time of the refused call").isLessThan(Victim.CPU);
    assertThat(box.proxy().put("still serving")).isGreaterThan(1);
  }

  /** Sets in sets, none of them twice. */
  private static Object nested(int levels) {
    Set<Object> set = new HashSet<>();
    for (int i = 1; i < levels; i++) {
      set = new HashSet<>(Set.of(set));
    }
    return set;
  }

  /**
   * Pairs of sets, each of which holds both of the pair before. Their hash codes take two to the
   * power of the pairs' number. None is deep in the stream: each refers back.
   */
  private static Object ladder(int sets) {
    List<Set<Object>> rungs = new ArrayList<>();
    Set<Object> one = new HashSet<>();
    Set<Object> other = new HashSet<>();
    for (int i = 0; i < sets / 2; i++) {
      rungs.add(one);
      rungs.add(other);
      Set<Object> below = new HashSet<>(Set.of("x")); // not equal to the next before it is filled
      Set<Object> beside = new HashSet<>();
      one.addAll(List.of(below, beside));
      other.addAll(List.of(below, beside));
      one = below;
      other = beside;
    }
    Collections.reverse(rungs); // the lowest is written first
    return rungs.toArray();
  }

  /** A set of lists whose hash codes are equal. */
  private static Object colliding(int count) {
    Set<List<Object>> set = new HashSet<>();
    List<List<Object>> keys = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      List<Object> key = new ArrayList<>(List.of(i));
      keys.add(key);
      set.add(key);
    }
    for (int i = 0; i < count; i++) { // now, since the set would take as long as its reader
      keys.get(i).set(0, text(i));
    }
    return set;
  }

  /** Texts with the same hash code, different for numbers below 65 536. */
  private static String text(int number) {
    StringBuilder text = new StringBuilder();
    for (int bit = 0; bit < Short.SIZE; bit++) {
      text.append(EQUAL_HASHES[(number >> bit) & 1]);
    }
    return text.toString();
  }
}
