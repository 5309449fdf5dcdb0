package org.dfra.behaviors.fuzzy;

import java.io.IOException;
import java.math.BigDecimal;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.dfra.behaviors.fuzzy.FisDocument.FisLine;
import org.dfra.behaviors.fuzzy.FisDocument.Section;
import org.dfra.behaviors.fuzzy.FuzzySystem.Rule;
import org.dfra.behaviors.fuzzy.Variable.Term;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.NearestName;
import org.dfra.core.config.SourceLocation;

/** Reads {@code .fis} files of MATLAB and other toolboxes. */
final class FisReader {

  private static final String QUOTED = "\\s*'([^']*)'\\s*";
  private static final Pattern TEXT = Pattern.compile(QUOTED);
  private static final Pattern LIST = Pattern.compile("\\s*\\[([^\\]]*)\\]\\s*");
  private static final Pattern TERM =
      Pattern.compile(QUOTED + ":" + QUOTED + ",\\s*\\[([^\\]]*)\\]\\s*");

  private final String file;
  private final FisDocument sections;

  private FisReader(String file, FisDocument sections) {
    this.file = file;
    this.sections = sections;
  }

  /**
   * Reads a file.
   *
   * @throws ConfigurationException naming file, line and word of the error
   */
  public static FuzzySystem read(Path file) {
    return parse(text(file), file.toString());
  }

  /**
   * Reads a text.
   *
   * @param file name used in error messages
   * @throws ConfigurationException naming file, line and word of the error
   */
  public static FuzzySystem parse(String text, String file) {
    return new FisReader(file, FisDocument.of(text, file)).system();
  }

  private static String text(Path file) {
    try {
      byte[] bytes = Files.readAllBytes(file);
      try {
        return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
      } catch (CharacterCodingException e) {
        return new String(bytes, Charset.forName("windows-1252")); // format of old MATLAB versions
      }
    } catch (NoSuchFileException e) {
      throw new ConfigurationException(
          file + ": there is no such file; name the .fis file of a fuzzy system", e);
    } catch (IOException e) {
      throw new ConfigurationException(
          file + ": the file cannot be read (" + e + "); name a readable file", e);
    }
  }

  private FuzzySystem system() {
    Section system = sections.section("System");
    system.requireKnown(
        List.of(
            "Name",
            "Type",
            "Version",
            "NumInputs",
            "NumOutputs",
            "NumRules",
            "AndMethod",
            "OrMethod",
            "ImpMethod",
            "AggMethod",
            "DefuzzMethod"));
    FuzzySystem.Type type = constant(system.line("Type"), FuzzySystem.Type.class);
    Operators methods =
        new Operators(
            constant(system.line("AndMethod"), Operators.And.class),
            constant(system.line("OrMethod"), Operators.Or.class),
            constant(system.line("ImpMethod"), Operators.Implication.class),
            constant(system.line("AggMethod"), Operators.Aggregation.class),
            constant(system.line("DefuzzMethod"), Operators.Defuzzification.class));
    List<Variable> inputs = variables("Input", count(system.line("NumInputs")), true);
    boolean isMamdani = type == FuzzySystem.Type.MAMDANI;
    List<Variable> outputs = variables("Output", count(system.line("NumOutputs")), isMamdani);
    sections.requireKnown(inputs.size(), outputs.size());
    FisLine rules = system.line("NumRules");
    FisRuleParser rulesReader = new FisRuleParser(inputs.size(), outputs.size());
    List<Rule> read = new ArrayList<>();
    for (FisLine line : sections.section("Rules").lines()) {
      Rule rule = rulesReader.rule(line);
      int number = read.size() + 1;
      fitting(
          line.place(),
          () -> {
            FuzzySystem.requireRule(rule, number, type, inputs, outputs);
            return rule;
          });
      read.add(rule);
    }
    if (read.size() != count(rules)) {
      throw rules.fault(
          "NumRules is " + rules.value() + ", but there are " + read.size() + " rules");
    }
    return fitting(
        new SourceLocation(file, 0),
        () ->
            new FuzzySystem(
                matched(TEXT, system.line("Name"), "a name in quotes").group(1),
                type,
                methods,
                inputs,
                outputs,
                read));
  }

  private List<Variable> variables(String what, int count, boolean hasSets) {
    return IntStream.rangeClosed(1, count)
        .mapToObj(number -> variable(sections.section(what + number), hasSets))
        .toList();
  }

  private static Variable variable(Section section, boolean hasSets) {
    String name = matched(TEXT, section.line("Name"), "a name in quotes").group(1);
    FisLine range = section.line("Range");
    double[] ends =
        FisNumberParser.list(range, matched(LIST, range, "two numbers in brackets").group(1));
    if (ends.length != 2) {
      throw range.fault("the range of " + name + " has " + ends.length + " ends; write [low high]");
    }
    FisLine number = section.line("NumMFs");
    List<FisLine> lines = section.numbered("MF");
    if (lines.size() != count(number)) {
      throw number.fault(
          "NumMFs of "
              + name
              + " is "
              + number.value()
              + ", but there are "
              + lines.size()
              + " membership functions");
    }
    List<Term> terms = lines.stream().map(line -> term(line, hasSets)).toList();
    return fitting(range.place(), () -> new Variable(name, ends[0], ends[1], terms));
  }

  private static Term term(FisLine line, boolean isSet) {
    Matcher parts = matched(TERM, line, "'name':'type',[parameters]");
    String word = parts.group(2);
    List<Double> numbers =
        Arrays.stream(FisNumberParser.list(line, parts.group(3))).boxed().toList();
    return new Term(
        parts.group(1),
        fitting(
            line.place(), () -> isSet ? set(line, word, numbers) : function(line, word, numbers)));
  }

  /** Old files pad parameter lists with zeros. */
  private static MembershipFunction set(FisLine line, String word, List<Double> numbers) {
    MembershipFunctionType type =
        MembershipFunctionType.of(word)
            .orElseThrow(
                () ->
                    line.fault(
                        "the membership function type \""
                            + word
                            + "\" is unknown"
                            + NearestName.hint(word, words(), "; use one of " + words())));
    int arity = type.parameters().size();
    boolean isPadded =
        numbers.size() > arity
            && numbers.subList(arity, numbers.size()).stream().allMatch(each -> each == 0);
    return new MembershipFunction(type, isPadded ? numbers.subList(0, arity) : numbers);
  }

  private static List<String> words() {
    return Arrays.stream(MembershipFunctionType.values())
        .map(MembershipFunctionType::fisName)
        .toList();
  }

  private static LinearFunction function(FisLine line, String word, List<Double> numbers) {
    if (word.equals(LinearFunction.LINEAR)) {
      return LinearFunction.linear(numbers);
    } else if (word.equals(LinearFunction.CONSTANT)) {
      boolean isPadded = numbers.stream().skip(1).allMatch(each -> each == 0);
      if (numbers.isEmpty() || !isPadded) {
        throw line.fault("constant takes one number, not " + numbers);
      }
      return LinearFunction.constant(numbers.get(0));
    }
    throw line.fault("the type \"" + word + "\" is unknown; write constant or linear");
  }

  private static int count(FisLine line) {
    return FisNumberParser.integer(line, line.value());
  }

  private static <E extends Enum<E>> E constant(FisLine line, Class<E> type) {
    String word = matched(TEXT, line, "a word in quotes").group(1);
    List<String> words = Arrays.stream(type.getEnumConstants()).map(Operators::fisName).toList();
    int place = words.indexOf(word);
    if (place < 0) {
      throw line.fault(
          line.key()
              + " is \""
              + word
              + "\", which is unknown"
              + NearestName.hint(word, words, "; use one of " + words));
    }
    return type.getEnumConstants()[place];
  }

  private static Matcher matched(Pattern pattern, FisLine line, String wanted) {
    Matcher matcher = pattern.matcher(line.value());
    if (!matcher.matches()) {
      throw line.fault(line.key() + " is \"" + line.value().strip() + "\", but must be " + wanted);
    }
    return matcher;
  }

  private static <T> T fitting(SourceLocation place, Supplier<T> made) {
    try {
      return made.get();
    } catch (ConfigurationException e) {
      throw e;
    } catch (IllegalArgumentException e) {
      throw new ConfigurationException(place + ": " + e.getMessage(), e);
    }
  }

  /** Parses numbers of {@code .fis} files; integers may have zero decimals. */
  static final class FisNumberParser {

    private FisNumberParser() {}

    /** Numbers separated by spaces or commas. */
    static double[] list(FisLine line, String text) {
      String stripped = text.strip();
      return stripped.isEmpty()
          ? new double[0]
          : Arrays.stream(stripped.split("[\\s,]+"))
              .mapToDouble(word -> number(line, word))
              .toArray();
    }

    static double number(FisLine line, String word) {
      if (word.matches("[-+]?Inf(inity)?")) {
        return word.startsWith("-") ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
      }
      try {
        // Not Double.parseDouble: it also accepts "0x1p3", "9f" and "NaN".
        return new BigDecimal(word).doubleValue();
      } catch (NumberFormatException e) {
        throw line.fault("\"" + word + "\" is not a number");
      }
    }

    static int integer(FisLine line, String text) {
      double number = number(line, text.strip());
      if (number != Math.rint(number) || Math.abs(number) > 1e6) {
        throw line.fault("\"" + text.strip() + "\" is not a whole number");
      }
      return (int) number;
    }
  }

  /** Reads the rules of a {@code .fis} file, {@code 1 -2, 3 (1) : 1} each. */
  private static final class FisRuleParser {

    private static final Pattern RULE =
        Pattern.compile("([^,]+),([^(]*)\\(([^)]*)\\)\\s*:\\s*(\\S+)");

    private final int inputs;
    private final int outputs;

    FisRuleParser(int inputs, int outputs) {
      this.inputs = inputs;
      this.outputs = outputs;
    }

    Rule rule(FisLine line) {
      Matcher parts = RULE.matcher(line.value());
      if (!parts.matches()) {
        throw line.fault(
            "\""
                + line.value()
                + "\" is not a rule; write: terms, terms (weight) : 1 (and) or 2 (or)");
      }
      List<Integer> antecedents = terms(line, parts.group(1), inputs, "inputs");
      List<Integer> consequents = terms(line, parts.group(2), outputs, "outputs");
      double weight = FisNumberParser.number(line, parts.group(3).strip());
      int connective = FisNumberParser.integer(line, parts.group(4));
      if (connective != 1 && connective != 2) {
        throw line.fault("the connective \"" + parts.group(4) + "\" is neither 1 (and) nor 2 (or)");
      }
      try {
        return new Rule(
            antecedents,
            consequents,
            weight,
            connective == 1 ? Rule.Connective.AND : Rule.Connective.OR);
      } catch (IllegalArgumentException e) {
        throw line.fault(String.valueOf(e.getMessage()));
      }
    }

    private static List<Integer> terms(FisLine line, String text, int wanted, String what) {
      List<Integer> terms =
          Arrays.stream(text.strip().split("\\s+"))
              .filter(word -> !word.isEmpty())
              .map(word -> FisNumberParser.integer(line, word))
              .toList();
      if (terms.size() != wanted) {
        throw line.fault(
            "the rule \""
                + line.value()
                + "\" has terms of "
                + terms.size()
                + " "
                + what
                + "; the system has "
                + wanted);
      }
      return terms;
    }
  }
}
