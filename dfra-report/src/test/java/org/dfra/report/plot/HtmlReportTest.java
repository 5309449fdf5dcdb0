package org.dfra.report.plot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class HtmlReportTest {

  @TempDir Path folder;

  private static HtmlReport report() {
    Page page =
        new Page("Speed of <atrv1>")
            .row(
                150,
                new LinePanel("Speed", Axis.of("time", "s"), Axis.of("speed", "m/s"))
                    .add(Series.line("a", new double[] {0, 1}, new double[] {0, 1})));
    return new HtmlReport("Run 7 & 8 <fast>")
        .heading("What came of it")
        .paragraph("It went \"well\" <script>alert(1)</script>.")
        .table(List.of("robot", "speed"), List.of(List.of("atrv1", "< 1 m/s")))
        .figure(page, "First & best")
        .figure(page, "");
  }

  @Test
  void escapesItsTextAndRunsNothing() {
    String html = report().html();
    assertThat(html)
        .contains("<title>Run 7 &amp; 8 &lt;fast&gt;</title>")
        .contains("<p>It went &quot;well&quot; &lt;script&gt;alert(1)&lt;/script&gt;.</p>")
        .contains("<td>atrv1</td><td class=\"n\">&lt; 1\u00a0m/s</td>")
        .contains("<figcaption>First &amp; best</figcaption>")
        .doesNotContain("<script")
        .doesNotContainPattern("\\son\\w+=");
  }

  @Test
  void showsWhatCannotBeSeen() {
    String name = "gps\u001b[2J\u202e<b>\u009b";
    String shown = "gps\\u001b[2J\\u202e&lt;b&gt;\\u009b";
    Page page =
        new Page(name)
            .row(150, new TextPanel(name, List.of(name), 1))
            .row(
                150,
                new LinePanel(name, Axis.of(name, "s"), Axis.of(name, "m/s"))
                    .add(Series.line(name, new double[] {0, 1}, new double[] {0, 1})));
    String html =
        new HtmlReport(name)
            .verdict(true, name)
            .heading(name)
            .paragraph(name)
            .table(List.of(name), List.of(List.of(name)))
            .figure(page, name)
            .image(new byte[] {1}, "image/png", name)
            .html();
    assertThat(html)
        .contains("<title>" + shown, "<h1>" + shown, "<h2>" + shown, "<p>" + shown)
        .contains("<th>" + shown, "<td>" + shown, "<figcaption>" + shown, "alt=\"" + shown)
        .doesNotContain("<b>")
        .doesNotContainPattern("[\\p{Cc}\\p{Cf}&&[^\n\t]]");
  }

  @Test
  void needsNoOtherFile() {
    assertThat(report().html()).doesNotContainPattern("(?:src|href)=\"(?!#)");
  }

  @Test
  void holdsItsFiguresWithIdsThatDiffer() {
    String html = report().html();
    assertThat(html.split("<svg ", -1)).hasSize(3);
    List<String> ids =
        Pattern.compile("\\bid=\"([^\"]+)\"")
            .matcher(html)
            .results()
            .map(found -> found.group(1))
            .toList();
    assertThat(ids).isNotEmpty().doesNotHaveDuplicates();
    Pattern.compile("url\\(#([^)]+)\\)")
        .matcher(html)
        .results()
        .forEach(found -> assertThat(ids).contains(found.group(1)));
  }

  @Test
  void isWrittenTheSameEachTime() throws Exception {
    Path one = folder.resolve("one.html");
    report().write(one);
    assertThat(Files.readString(one)).isEqualTo(report().html());
  }

  @Test
  void refusesARowThatDoesNotFit() {
    assertThatThrownBy(
            () -> new HtmlReport("").table(List.of("a"), List.of(Arrays.asList("1", "2"))))
        .hasMessage("2 cells in a table of 1 columns");
  }
}
