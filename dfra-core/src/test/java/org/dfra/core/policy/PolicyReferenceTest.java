package org.dfra.core.policy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.core.policy.method.MethodKind;
import org.junit.jupiter.api.Test;

/** The reference for users says what the schema and the reader say, and its examples are valid. */
class PolicyReferenceTest {

  private static final Path FILE =
      Path.of(Objects.requireNonNull(System.getProperty("dfra.root"), "dfra.root is not set"))
          .resolve("docs/reference/policy.md");

  private static final Pattern HEADING = Pattern.compile("(?m)^##+ (.*)$");
  private static final Pattern ROW = Pattern.compile("(?m)^\\| `([^`]+)`[^|]* \\|");
  private static final Pattern EXAMPLE = Pattern.compile("(?ms)^```xml\\n(.*?)^```$");

  /** The first column of the tables below each heading. */
  private static Map<String, List<String>> tables() throws IOException {
    String text = Files.readString(FILE);
    List<MatchResult> headings = HEADING.matcher(text).results().toList();
    Map<String, List<String>> tables = new TreeMap<>();
    for (int i = 0; i < headings.size(); i++) {
      int end = i + 1 < headings.size() ? headings.get(i + 1).start() : text.length();
      String section = text.substring(headings.get(i).end(), end);
      tables.put(
          headings.get(i).group(1),
          ROW.matcher(section).results().map(row -> row.group(1)).toList());
    }
    return tables;
  }

  @Test
  void describesEveryElementAndAttributeOfTheSchemaAndNoOther() throws IOException {
    Map<String, List<String>> described = tables();
    described.keySet().removeIf(heading -> !heading.startsWith("`<"));
    assertThat(described).hasSize(16);
    Map<String, List<String>> declared = PolicyXml.attributes();
    assertThat(described.keySet())
        .containsExactlyInAnyOrderElementsOf(
            declared.keySet().stream().map(each -> "`<" + each + ">`").toList());
    declared.forEach(
        (element, attributes) ->
            assertThat(described.get("`<" + element + ">`"))
                .as("attributes of <%s>", element)
                .containsExactlyInAnyOrderElementsOf(attributes));
  }

  @Test
  void describesEveryKindAndStandingInTheirOrder() throws IOException {
    assertThat(tables().get("Kinds of methods"))
        .containsExactlyElementsOf(
            Arrays.stream(MethodKind.values()).map(MethodKind::text).toList());
    assertThat(tables().get("Standings")).containsExactly("own", "member", "expired", "stranger");
  }

  @Test
  void itsExamplesAreValidAndItsLimitsRight() throws IOException {
    String text = Files.readString(FILE);
    List<String> examples = EXAMPLE.matcher(text).results().map(each -> each.group(1)).toList();
    assertThat(examples).hasSize(5);
    for (String each : examples) {
      Policy policy =
          PolicyXml.read(
              each.getBytes(StandardCharsets.UTF_8), "example", InterfaceCatalogue.builtIn());
      assertThat(policy.rules()).hasSizeGreaterThan(3);
    }
    assertThat(text)
        .contains("`" + PolicyXml.namespace() + "`")
        .contains((PolicyXml.MAX_BYTES >> 10) + " KiB and " + PolicyXml.MAX_RULES + " rules")
        .contains("at most " + PolicyXml.MAX_BUDGETS + " budgets and radios")
        .contains(PolicyXml.MAX_VISIBILITY_RULES + " `<show>` and `<hide>`")
        .contains("3 to " + PolicyRegion.MAX_CORNERS + " corners")
        .contains("1 to " + Obligations.RateLimit.MAX_CALLS)
        .contains("Beyond " + CallRateLimiter.MAX_CALLERS + " callers")
        .contains("for " + ConfirmationRequests.KEPT_SECONDS + " s")
        .contains("at most " + DecisionLog.MAX_LINES + " in a second");
  }
}
