package org.dfra.behaviors.fuzzy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import org.dfra.behaviors.fuzzy.FuzzySystem.Rule;
import org.dfra.behaviors.fuzzy.FuzzySystem.ToolboxCompatibility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code config/fuzzy/waypoint.fis} is complete, and drives as its comments say. */
class WaypointControllerTest {

  private static final Path ROOT = Path.of(System.getProperty("dfra.root", "."));
  private static final FuzzySystem CONTROLLER =
      FuzzySystem.read(ROOT.resolve("config/fuzzy/waypoint.fis"));
  private static final Path REFERENCE =
      ROOT.resolve("../shared/data/fuzzy/proposed_atrvjr.csv").normalize();
  private static final double FREE = 8;

  /**
   * A centroid over 101 points misses the middle of a symmetric term by a part of their distance.
   */
  private static final double GRID = 1e-3;

  /** What it commands: parts of the highest speed and turn rate, + is left. */
  private record Command(double tr, double rv) {}

  private static Command command(double left, double centre, double right, double headingError) {
    double[] command = new double[2];
    CONTROLLER.inference().evaluate(new double[] {left, centre, right, headingError}, command);
    return new Command(command[0], command[1]);
  }

  @Test
  void namesWhatItReadsAndCommands() {
    assertThat(CONTROLLER.inputs())
        .extracting(Variable::name)
        .containsExactly("left", "centre", "right", "heading_error");
    assertThat(CONTROLLER.outputs()).extracting(Variable::name).containsExactly("tr", "rv");
    assertThat(CONTROLLER.type()).isEqualTo(FuzzySystem.Type.MAMDANI);
    assertThat(CONTROLLER.operators()).isEqualTo(Operators.MAMDANI);
  }

  @Test
  void hasOneRuleForEachCombinationOfTerms() {
    Set<List<Integer>> combinations =
        CONTROLLER.rules().stream().map(Rule::antecedents).collect(Collectors.toSet());
    assertThat(CONTROLLER.rules())
        .hasSize(3 * 3 * 3 * 5)
        .allSatisfy(
            rule -> {
              assertThat(rule.antecedents()).allMatch(term -> term > 0);
              assertThat(rule.consequents()).allMatch(term -> term > 0);
              assertThat(rule.weight()).isEqualTo(1);
              assertThat(rule.connective()).isEqualTo(Rule.Connective.AND);
            });
    assertThat(combinations).as("combinations, each written once").hasSize(135);
  }

  @Test
  void someRuleFiresByHalfWhereverTheRobotIsAndItsCommandsAreWithinLimits() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    Inference inference = CONTROLLER.inference();
    double[] command = new double[2];
    for (int i = 0; i < 20_000; i++) {
      double[] inputs = {
        random.nextDouble() * FREE,
        random.nextDouble() * FREE,
        random.nextDouble() * FREE,
        random.nextDouble() * 360 - 180
      };
      inference.evaluate(inputs, command);
      String what = "-Ddfra.seed=" + seed + ", at " + Arrays.toString(inputs);
      // Neighbouring terms cross at 0.5, so one of each input's is at least that.
      assertThat(Arrays.stream(inference.strengths()).max().orElseThrow())
          .as(what)
          .isGreaterThanOrEqualTo(0.5 - 1e-12);
      assertThat(command[0]).as("tr, " + what).isBetween(-GRID, 1 + GRID);
      assertThat(command[1]).as("rv, " + what).isBetween(-1 - GRID, 1 + GRID);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {8, 20, 45, 90, 135, 180})
  void turnsToTheGoalInTheOpenAndTheHarderTheFartherItIsOff(double off) {
    Command left = command(FREE, FREE, FREE, off);
    Command right = command(FREE, FREE, FREE, -off);
    assertThat(left.rv()).isPositive();
    assertThat(right.rv()).isCloseTo(-left.rv(), within(1e-9));
    assertThat(right.tr()).isCloseTo(left.tr(), within(1e-9));
    assertThat(command(FREE, FREE, FREE, off / 2).rv()).isLessThanOrEqualTo(left.rv() + 1e-9);
  }

  @Test
  void drivesFastAndStraightToAGoalAheadInTheOpen() {
    Command ahead = command(FREE, FREE, FREE, 0);
    assertThat(ahead.tr()).isCloseTo(1, within(GRID));
    assertThat(ahead.rv()).isCloseTo(0, within(GRID));
  }

  @Test
  void turnsOnTheSpotToAGoalBehindIt() {
    assertThat(command(FREE, FREE, FREE, 170).tr()).isCloseTo(0, within(GRID));
    assertThat(command(FREE, FREE, FREE, 170).rv()).isCloseTo(1, within(GRID));
  }

  @ParameterizedTest
  @CsvSource({"8, 8", "0.5, 8", "8, 0.5", "1.5, 1.5", "0.5, 0.5"})
  void slowsDownTheNearerSomethingIsAheadAndStopsBeforeIt(double left, double right) {
    double before = Double.POSITIVE_INFINITY;
    for (double centre : new double[] {8, 4.2, 3, 1.4, 0.9}) {
      double tr = command(left, centre, right, 0).tr();
      assertThat(tr).as("%.1f m ahead", centre).isLessThanOrEqualTo(before + GRID);
      before = tr;
    }
    assertThat(command(left, 3, right, 0).tr()).as("medium").isCloseTo(0.45, within(GRID));
    assertThat(before).as("close").isCloseTo(0, within(GRID));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.5, 1.5, 8})
  void keepsRightWhereBothSidesAreAlikeWhereverTheGoalIs(double side) {
    for (double goal : new double[] {-100, -20, 0, 20, 100}) {
      Command near = command(side, 0.8, side, goal);
      assertThat(near.rv()).as("goal at %.0f°", goal).isCloseTo(-1, within(GRID));
      assertThat(near.tr()).isCloseTo(0, within(GRID));
    }
  }

  @Test
  void twoRobotsHeadOnBearOffToTheRightInGoodTime() {
    assertThat(command(FREE, 3, FREE, 0).rv()).isLessThan(-0.3);
    assertThat(command(FREE, 3, FREE, 20).rv()).as("goal to the left").isLessThan(-0.3);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-100, -30, 0, 30, 100})
  void neverTurnsToASideThatIsClose(double goal) {
    for (double centre : new double[] {0.5, 3, 8}) {
      Command leftClose = command(0.5, centre, FREE, goal);
      Command rightClose = command(FREE, centre, 0.5, -goal);
      assertThat(leftClose.rv()).as("%.1f m ahead", centre).isLessThan(1e-9);
      assertThat(rightClose.rv()).as("mirrored").isCloseTo(-leftClose.rv(), within(1e-9));
    }
  }

  /** The design that it was written from, as MATLAB's arithmetic and Octave's evaluate it. */
  @ParameterizedTest
  @CsvSource({"MATLAB, 6", "OCTAVE, 4"})
  void agreesWithTheDesignItWasWrittenFrom(ToolboxCompatibility engine, int column)
      throws Exception {
    assumeTrue(Files.exists(REFERENCE), "the folder with others' fuzzy systems is absent");
    Inference inference = CONTROLLER.inference(engine);
    double[] command = new double[2];
    List<String> rows = Files.readAllLines(REFERENCE);
    assertThat(rows.get(0)).isEqualTo(header());
    assertThat(rows).hasSizeGreaterThan(300);
    for (String row : rows.subList(1, rows.size())) {
      double[] values = Arrays.stream(row.split(",")).mapToDouble(Double::parseDouble).toArray();
      inference.evaluate(Arrays.copyOf(values, 4), command);
      assertThat(command[0]).as(row).isCloseTo(values[column], within(1e-9));
      assertThat(command[1]).as(row).isCloseTo(values[column + 1], within(1e-9));
    }
  }

  private static String header() {
    return "in1,in2,in3,in4,octave_out1,octave_out2,matlab_out1,matlab_out2";
  }
}
