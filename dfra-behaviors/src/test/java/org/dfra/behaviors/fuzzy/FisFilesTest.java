package org.dfra.behaviors.fuzzy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.dfra.behaviors.fuzzy.FuzzySystem.Rule;
import org.dfra.behaviors.fuzzy.FuzzySystem.ToolboxCompatibility;
import org.dfra.core.config.ConfigurationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FisFilesTest {

  private static final Path SYSTEMS =
      Path.of(System.getProperty("dfra.root", "."), "..", "shared", "data", "fuzzy");

  private static final String SMALL =
      """
      % a comment
      [System]
      Name = 'small'
      Type='mamdani'
      NumInputs=1.000
      NumOutputs=1
      NumRules=2
      AndMethod='min'
      OrMethod='max'
      ImpMethod='min'
      AggMethod='max'
      DefuzzMethod='centroid'

      [Input1]
      Name='x'
      Range=[-1 1]
      NumMFs=2
      MF1='low':'trimf',[-1 -0.5 0 0]
      MF2='high':'gaussmf',[ .5 1 ]

      # another
      [Output1]
      Name='y'
      Range=[0 10]
      NumMFs=1
      MF1='some':'trapmf',[0 2 4 1e1]

      [Rules]
      1, 1 (1) : 1
      -2.000 , 1 (0.5) : 2""";

  @TempDir Path folder;

  private static List<Path> systems(String prefix, boolean wanted) {
    assumeTrue(Files.isDirectory(SYSTEMS), "the folder with others' fuzzy systems is absent");
    try (Stream<Path> files = Files.list(SYSTEMS)) {
      return files
          .filter(file -> file.toString().endsWith(".fis"))
          .filter(file -> file.getFileName().toString().startsWith(prefix) == wanted)
          .sorted()
          .toList();
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  @Test
  void agreesWithBothToolboxesOnSystemsOfOthers() throws IOException {
    int checked = 0;
    for (Path file : systems("refuse_", false)) {
      FuzzySystem system = FuzzySystem.read(file);
      Path table = Path.of(file.toString().replace(".fis", ".csv"));
      List<String> rows = Files.readAllLines(table);
      List<String> header = Arrays.asList(rows.get(0).split(","));
      for (ToolboxCompatibility engine : ToolboxCompatibility.values()) {
        Inference inference = system.inference(engine);
        double[] outputs = new double[system.outputs().size()];
        int first = header.indexOf(Operators.fisName(engine) + "_out1");
        for (String row : rows.subList(1, rows.size())) {
          double[] values =
              Arrays.stream(row.split(",")).mapToDouble(Double::parseDouble).toArray();
          inference.evaluate(Arrays.copyOf(values, system.inputs().size()), outputs);
          for (int i = 0; i < outputs.length; i++) {
            double wanted = values[first + i];
            String what = file.getFileName() + ", " + engine + ": " + row;
            if (Double.isNaN(wanted)) {
              assertThat(outputs[i]).as(what).isNaN();
            } else {
              assertThat(outputs[i]).as(what).isCloseTo(wanted, within(1e-9));
            }
            checked++;
          }
        }
      }
    }
    assertThat(checked).isGreaterThan(5_000);
  }

  @Test
  void refusesMembershipTypesThatItDoesNotKnow() {
    for (Path file : systems("refuse_", true)) {
      assertThatThrownBy(() -> FuzzySystem.read(file))
          .isInstanceOf(ConfigurationException.class)
          .hasMessageMatching(
              "\\Q" + file + "\\E:\\d+: the membership function type \"\\w+mf\" is unknown.*");
    }
  }

  @Test
  void writesSystemsOfOthersBackEqual() {
    for (Path file : systems("refuse_", false)) {
      FuzzySystem system = FuzzySystem.read(file);
      assertThat(FisReader.parse(FisWriter.text(system), "written")).isEqualTo(system);
    }
  }

  @Test
  void writesRandomSystemsBackEqual() throws IOException {
    RandomSystems systems = new RandomSystems(7);
    Path file = folder.resolve("random.fis");
    for (int i = 0; i < 300; i++) {
      FuzzySystem system = systems.next();
      FisWriter.write(system, file);
      assertThat(FuzzySystem.read(file)).isEqualTo(system);
      assertThat(FisWriter.text(FuzzySystem.read(file))).isEqualTo(Files.readString(file));
    }
  }

  @Test
  void readsBlanksCommentsPaddingAndDecimals() {
    FuzzySystem small = FisReader.parse(SMALL, "small.fis");
    assertThat(small.name()).isEqualTo("small");
    assertThat(small.inputs().get(0).terms().get(0).function())
        .isEqualTo(new MembershipFunction(MembershipFunctionType.TRIMF, List.of(-1.0, -0.5, 0.0)));
    assertThat(small.rules().get(1))
        .isEqualTo(new Rule(List.of(-2), List.of(1), 0.5, Rule.Connective.OR));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "[System] | [Sistem] | small.fis: the section [System] is missing; check that this is a complete .fis file",
        "Type='mamdani' | Type='mandani'"
            + " | small.fis:4: Type is \"mandani\", which is unknown; did you mean \"mamdani\"?",
        "Type='mamdani' | Tipe='mamdani'"
            + " | small.fis:4: \"Tipe\" is not a key of [System]; did you mean \"Type\"?",
        "NumInputs=1.000 | NumInputs=one | small.fis:5: \"one\" is not a number",
        "NumInputs=1.000 | NumInputs=1.5 | small.fis:5: \"1.5\" is not a whole number",
        "NumInputs=1.000 | NumInputs=2 | small.fis: the section [Input2] is missing; check that this is a complete .fis file",
        "NumRules=2 | NumRules=3 | small.fis:7: NumRules is 3, but there are 2 rules",
        "'centroid' | 'wtaver'"
            + " | small.fis: the defuzzification wtaver is not for a system of type mamdani",
        "Range=[-1 1] | Range=[-1 1 3] | small.fis:16: the range of x has 3 ends; write [low high]",
        "Range=[-1 1] | Range=[1 -1]"
            + " | small.fis:16: the range of x requires low ≤ high, not 1.0 and -1.0",
        "'trimf' | 'trinf' | small.fis:18: the membership function type \"trinf\" is unknown; did you mean \"trimf\"?",
        "[-1 -0.5 0 0] | [-1 -0.5 x] | small.fis:18: \"x\" is not a number",
        "[-1 -0.5 0 0] | [-1 -0.5] | small.fis:18: trimf takes the parameters [a, b, c], not [-1.0, -0.5]",
        "[-1 -0.5 0 0] | [0 -0.5 0 0] | small.fis:18: trimf [a, b, c] requires a ≤ b ≤ c, not [0.0, -0.5, 0.0]",
        "MF2='high' | MF3='high'"
            + " | small.fis:19: MF3 is in the place of MF2; number them from 1 on",
        "NumMFs=2 | NumMFs=4"
            + " | small.fis:17: NumMFs of x is 4, but there are 2 membership functions",
        "1, 1 (1) : 1 | 3, 1 (1) : 1 | small.fis:29: rule 1 uses term 3 of x, which has 2 terms",
        "1, 1 (1) : 1 | 1 1, 1 (1) : 1 | small.fis:29: the rule \"1 1, 1 (1) : 1\" has terms of 2 inputs; the system has 1",
        "1, 1 (1) : 1 | 1, 1 (1) : 3 | small.fis:29: the connective \"3\" is neither 1 (and) nor 2 (or)",
        "1, 1 (1) : 1 | 1, 1 (2) : 1 | small.fis:29: the weight 2.0 is not from 0 to 1",
        "1, 1 (1) : 1 | if x then y | small.fis:29: \"if x then y\" is not a rule; write: terms, terms (weight) : 1 (and) or 2 (or)",
        "# another | what is this | small.fis:21: \"what is this\" is neither key=value nor a [Heading] nor a comment",
        "# another | NumMFs=2 | small.fis:21: NumMFs is written twice in [Input1]; delete one",
        "# another | [Input1] | small.fis:21: [Input1] is written twice, first in line 14; delete one",
      })
  void reportsWhatIsWrongAndWhere(String right, String wrong, String sentence) {
    assertThat(SMALL).contains(right);
    String text = SMALL.replaceFirst(java.util.regex.Pattern.quote(right), wrong);
    assertThatThrownBy(() -> FisReader.parse(text, "small.fis"))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(sentence);
  }

  @Test
  void reportsTheLineOfABadRuleInTheMiddle() {
    String text =
        SMALL
            .replace("NumRules=2", "NumRules=3")
            .replace("-2.000 , 1 (0.5) : 2", "\n7, 1 (1) : 1\n2, 1 (1) : 1");
    assertThatThrownBy(() -> FisReader.parse(text, "small.fis"))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage("small.fis:31: rule 2 uses term 7 of x, which has 2 terms");
  }

  @Test
  void reportsThatAFileIsMissing() {
    Path missing = folder.resolve("nothing.fis");
    assertThatThrownBy(() -> FuzzySystem.read(missing))
        .hasMessage(missing + ": there is no such file; name the .fis file of a fuzzy system");
  }

  @Test
  void refusesNamesThatNoFileCanHold() {
    FuzzySystem small = FisReader.parse(SMALL, "small.fis");
    FuzzySystem odd =
        new FuzzySystem(
            "it's",
            small.type(),
            small.operators(),
            small.inputs(),
            small.outputs(),
            small.rules());
    assertThatThrownBy(() -> FisWriter.text(odd)).hasMessageContaining("contains a quote");
  }
}
