package org.dfra.report.plot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.dfra.report.plot.Series.Style;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Element;
import org.xml.sax.InputSource;

class PageTest {

  private static final Axis TIME = Axis.of("time", "s");
  private static final Axis SPEED = Axis.of("speed", "m/s");

  @TempDir Path folder;

  private static double[] numbers(int count) {
    return IntStream.range(0, count).asDoubleStream().toArray();
  }

  private static double[] waves(int count) {
    return Arrays.stream(numbers(count)).map(x -> Math.sin(x / 7)).toArray();
  }

  private static Page page(String title) {
    return new Page(title)
        .row(
            200,
            new LinePanel("Speed", TIME, SPEED)
                .add(Series.line("true", numbers(500), waves(500)))
                .moment(100, "GPS lost"),
            new PathPanel("Path", Axis.of("east", "m"), Axis.of("north", "m"))
                .add(Series.circle("post", 3, 4, 1)));
  }

  private static Element parsed(String svg) throws Exception {
    DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
    factory.setNamespaceAware(true);
    return factory
        .newDocumentBuilder()
        .parse(new InputSource(new StringReader(svg)))
        .getDocumentElement();
  }

  @Test
  void isAnSvgDocumentWithItsTitleAndSize() throws Exception {
    Page page = page("Wheels & <wires>");
    Element svg = parsed(page.svg());
    assertThat(svg.getNamespaceURI()).isEqualTo("http://www.w3.org/2000/svg");
    assertThat(svg.getAttribute("viewBox")).isEqualTo("0 0 " + page.width() + " " + page.height());
    assertThat(svg.getElementsByTagName("title").item(0).getTextContent())
        .isEqualTo("Wheels & <wires>");
    assertThat(svg.getElementsByTagName("script").getLength()).isZero();
  }

  @Test
  void givesTheSameBytesForTheSameInput() throws Exception {
    Path one = folder.resolve("one.svg");
    Path other = folder.resolve("other.svg");
    page("A page").write(one);
    page("A page").write(other);
    assertThat(Files.mismatch(one, other)).as("first byte that differs").isEqualTo(-1);
  }

  @Test
  void drawsSeriesAsOnePathHoweverManyPointsTheyHave() {
    for (Style style : Style.values()) {
      assertThat(elements(style, 5_000)).as(style.name()).isEqualTo(elements(style, 500));
    }
  }

  private static long elements(Style style, int points) {
    double[] x = Arrays.stream(numbers(points)).map(each -> each * 100 / points).toArray();
    double[] y = waves(points);
    Series series =
        switch (style) {
          case LINE -> Series.line("a", x, y);
          case STEPS -> Series.steps("a", x, y);
          case POINTS -> Series.points("a", x, y);
          case AREA -> Series.area("a", x, y);
        };
    String svg =
        new Page("")
            .row(200, new LinePanel("", TIME.between(0, 100), SPEED.between(-1, 1)).add(series))
            .svg();
    return svg.lines().filter(line -> line.matches(".*<(?!/|title|svg|text)\\w+\\b.*")).count();
  }

  @Test
  void theLegendIsNotCutAtThePlotWhereNothingElseIsWritten() {
    String svg =
        new Page("")
            .row(
                200,
                new LinePanel("", Axis.of("", ""), Axis.of("", ""))
                    .add(Series.line("a", numbers(9), waves(9))))
            .svg();
    String blue = "stroke=\"rgb(0,114,178)\"";
    assertThat(svg.split(Pattern.quote(blue), -1))
        .as("the line, and its sample in the legend")
        .hasSize(3);
  }

  @Test
  void givesPicturesInOneDocumentIdsOfTheirOwn() throws Exception {
    String both = "<html>" + page("A").element("one-") + page("B").element("two-") + "</html>";
    var all = parsed(both).getElementsByTagName("*");
    var ids =
        IntStream.range(0, all.getLength())
            .mapToObj(i -> ((Element) all.item(i)).getAttribute("id"))
            .filter(id -> !id.isEmpty())
            .toList();
    assertThat(ids).isNotEmpty().doesNotHaveDuplicates();
  }

  @Test
  void putsPanelsInRowsBelowOneAnother() {
    int[][] sizes = new int[3][];
    Page page =
        new Page("")
            .row(100, (g, width, height) -> sizes[0] = new int[] {width, height})
            .row(
                50,
                (g, width, height) -> sizes[1] = new int[] {width, height},
                (g, width, height) -> sizes[2] = new int[] {width, height});
    page.svg();
    assertThat(sizes[0][1]).isEqualTo(100);
    assertThat(sizes[1]).isEqualTo(sizes[2]);
    assertThat(2 * sizes[1][0]).isBetween(sizes[0][0] - 20, sizes[0][0]);
    assertThat(page.height()).isBetween(150, 180);
  }

  @Test
  void refusesARowWithNothingInIt() {
    assertThatThrownBy(() -> new Page("").row(100))
        .hasMessage("a row needs a panel or more and a height above 0, not 0 and 100");
  }
}
