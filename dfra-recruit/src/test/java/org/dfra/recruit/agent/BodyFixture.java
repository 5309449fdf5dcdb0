package org.dfra.recruit.agent;

import static org.dfra.recruit.agent.BodyModules.at;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dfra.agent.HelpCall;
import org.dfra.behavior.RasterGoal;
import org.dfra.recruit.agent.BodyModules.Driver;
import org.dfra.recruit.agent.BodyModules.Position;
import org.dfra.recruit.agent.BodyModules.Search;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.slf4j.LoggerFactory;

/** A robot with its modules, at the datum, and the body that its agent has of it. */
abstract class BodyFixture {

  static final RobotTraits TRAITS =
      new RobotTraits(List.of("mine"), 0.5, 1.2, 0.7, 0.2, at(0, 0), at(100, 50));
  static final HelpCall CALL =
      new HelpCall("mine", at(30, 40), Duration.ofSeconds(20), Duration.ofSeconds(100));
  static final RasterGoal FIELD =
      new RasterGoal(List.of(at(0, 0), at(9, 0), at(9, 9)), 2, 1.5, false);

  final BodyModules modules = new BodyModules();
  final Position position = modules.add(new Position(modules.context("position")));
  final Driver driver = modules.add(new Driver(modules.context("go_to_waypoint")));
  final Search search = modules.add(new Search(modules.context("raster_search")));

  /** What the body reported to {@link #journey}. */
  final List<String> reports = new ArrayList<>();

  final RobotPort.TravelListener journey =
      new RobotPort.TravelListener() {
        @Override
        public void arrived() {
          reports.add("arrived");
        }

        @Override
        public void failed(String why) {
          reports.add(why);
        }
      };

  ModuleRobotPort body = body();

  /** Another one, started. */
  ModuleRobotPort body() {
    ModuleRobotPort made =
        new ModuleRobotPort(modules.context("agent"), TRAITS, LoggerFactory.getLogger("test"));
    made.start();
    modules.step(0.1);
    return made;
  }

  @BeforeEach
  void atTheDatum() {
    position.see(0, 0);
    modules.step(0.1);
  }

  @AfterEach
  void end() {
    body.close();
    modules.close();
  }
}
