package org.dfra.app.demo.recruit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.reflect.Proxy;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import org.dfra.app.demo.stage.Narration;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.RasterSearch;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleQuery;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.junit.jupiter.api.Test;

/** Whether searches went on is judged by what they are at, of those that were left only. */
class SearchesTest {

  private final StringWriter said = new StringWriter();
  private final Map<String, Phase> phases = new HashMap<>();

  /** Stands for a robot's search, at whatever {@link #phases} says. */
  private RasterSearch search(String robot) {
    return (RasterSearch)
        Proxy.newProxyInstance(
            SearchesTest.class.getClassLoader(),
            new Class<?>[] {RasterSearch.class},
            (self, method, arguments) ->
                switch (method.getName()) {
                  case "pursue" -> UUID.randomUUID();
                  case "status" ->
                      new BehaviorStatus(
                          Instant.EPOCH, null, phases.get(robot), "it is as it is", 0.5, 0);
                  case "cancel" -> null;
                  default -> throw new UnsupportedOperationException(method.getName());
                });
  }

  private Searches begun() throws Exception {
    Map<ModuleQuery<?>, RasterSearch> all = new HashMap<>();
    phases
        .keySet()
        .forEach(each -> all.put(ModuleQuery.of(RasterSearch.class).robot(each), search(each)));
    ModuleDirectory directory =
        (ModuleDirectory)
            Proxy.newProxyInstance(
                SearchesTest.class.getClassLoader(),
                new Class<?>[] {ModuleDirectory.class},
                (self, method, arguments) -> all.get(arguments[0]));
    Searches searches =
        new Searches(
            new Narration(new PrintWriter(said), () -> 0),
            directory,
            new LocalFrame(new GeoPosition(48, 11, 0)),
            Duration.ofMillis(20));
    for (String robot : phases.keySet()) {
      searches.begin(robot, 0, 10, 0);
    }
    return searches;
  }

  @Test
  void onlyWhatRunsOrIsFinishedHasGoneOn() throws Exception {
    phases.put("runs", Phase.RUNNING);
    phases.put("is finished", Phase.SUCCEEDED);
    phases.put("failed", Phase.FAILED);
    phases.put("was given up", Phase.CANCELLED);
    phases.put("pauses", Phase.PAUSED);
    phases.put("knows of none", Phase.IDLE);
    List<String> idle = begun().end(Set.copyOf(phases.keySet()));
    assertThat(idle).containsExactlyInAnyOrder("failed", "was given up", "pauses", "knows of none");
  }

  @Test
  void whatWasNeverLeftCannotGoOnNorFailTo() throws Exception {
    phases.put("was called away", Phase.RUNNING);
    phases.put("was not", Phase.FAILED);
    assertThat(begun().end(Set.of("was called away", "never searched"))).isEmpty();
    assertThat(said.toString().replaceAll("\\s+", " ")) // lines may end anywhere
        .contains("was called away, which was called away, has searched 50 %")
        .contains("was not has searched 50 %");
  }
}
