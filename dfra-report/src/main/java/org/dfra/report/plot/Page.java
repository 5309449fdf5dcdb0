package org.dfra.report.plot;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * Panels in rows below a title, painted as one image. Confined to one thread.
 *
 * <pre>{@code
 * Page page = new Page("Two robots on one field");
 * page.row(420, new PathPanel("Paths", east, north).add(Series.line("atrv1", xs, ys)));
 * page.row(240, new LinePanel("Speed", time, speed).add(Series.line("atrv1", ts, vs)), other);
 * page.write(Path.of("run.svg"));
 * }</pre>
 */
public final class Page {

  private static final String HEAD = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  private static final int WIDTH = 1200;
  private static final int MARGIN = 6;
  private static final int TITLE_HEIGHT = 40;

  /** As SVG paints. */
  static final Map<RenderingHints.Key, Object> HINTS =
      Map.of(
          RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON,
          RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON,
          RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);

  private final String title;
  private final List<Row> rows = new ArrayList<>();

  private record Row(int height, List<Panel> panels) {}

  /**
   * @param title of the whole image; empty for none
   */
  public Page(String title) {
    this.title = title;
  }

  /**
   * Adds a row below the others.
   *
   * @param height in pixels; the page is 1200 wide
   * @param panels from left to right, of equal width
   */
  public Page row(int height, Panel... panels) {
    if (panels.length == 0 || height <= 0) {
      throw new IllegalArgumentException(
          "a row needs a panel or more and a height above 0, not "
              + panels.length
              + " and "
              + height);
    }
    rows.add(new Row(height, List.of(panels)));
    return this;
  }

  /** Its title. */
  public String title() {
    return title;
  }

  /** The width of each of this number of panels in a row, in pixels. */
  public static int panelWidth(int panels) {
    return (WIDTH - (panels + 1) * MARGIN) / panels;
  }

  /** In pixels. */
  public int width() {
    return WIDTH;
  }

  /** In pixels. */
  public int height() {
    return top() + rows.stream().mapToInt(row -> row.height() + MARGIN).sum();
  }

  private int top() {
    return MARGIN + (title.isEmpty() ? 0 : TITLE_HEIGHT);
  }

  /** Paints it from (0, 0) to its width and height, for example to a bitmap. */
  public void paint(Graphics2D g) {
    g.addRenderingHints(HINTS);
    g.setColor(Palette.PAPER);
    g.fill(new Rectangle2D.Double(0, 0, WIDTH, height()));
    PanelText.paint(
        g,
        PanelText.fitting(title, PanelText.TITLE, WIDTH - 2.0 * MARGIN),
        PanelText.TITLE,
        Palette.INK,
        WIDTH / 2.0,
        MARGIN + TITLE_HEIGHT / 2.0 + PanelText.height(PanelText.TITLE) / 2,
        PanelText.Side.MIDDLE);
    alignStacked();
    int y = top();
    for (Row row : rows) {
      int count = row.panels().size();
      int width = panelWidth(count);
      for (int i = 0; i < count; i++) {
        AffineTransform before = g.getTransform();
        g.translate(MARGIN + i * (width + MARGIN), y);
        row.panels().get(i).paint(g, width, row.height());
        g.setTransform(before);
      }
      y += row.height() + MARGIN;
    }
  }

  /** Single panels in consecutive rows share their horizontal axis. */
  private void alignStacked() {
    List<LinePanel> stacked = new ArrayList<>();
    int height = 0;
    for (Row row : rows) {
      if (row.panels().size() == 1
          && row.panels().get(0) instanceof LinePanel panel
          && (stacked.isEmpty() || panel.isOverTheSameAs(stacked.get(0)))) {
        stacked.add(panel);
        height = row.height();
      }
    }
    if (stacked.size() > 1) {
      LinePanel.align(stacked, panelWidth(1), height);
    }
  }

  /**
   * Sets Java's headless mode, so that it does not connect to a display. For programs without
   * windows; effective only before the first use of AWT.
   */
  public static void setHeadless() {
    System.setProperty("java.awt.headless", "true");
  }

  /**
   * The image as an SVG document.
   *
   * @throws NoFontException if no font is installed
   */
  public String svg() {
    return HEAD + element("");
  }

  /**
   * The image as an element {@code svg}.
   *
   * @param prefix of all IDs in it, so that several fit into one document
   */
  String element(String prefix) {
    PanelText.require();
    SvgCanvas canvas = SvgCanvas.of(WIDTH, height(), prefix);
    paint(canvas);
    return canvas.text(title);
  }

  /**
   * Writes the image to an SVG file.
   *
   * @throws NoFontException if no font is installed
   */
  public void write(Path file) throws IOException {
    write(element(""), file);
  }

  /** Writes an element {@code svg} to a separate file. */
  static void write(String element, Path file) throws IOException {
    Files.writeString(file, HEAD + element, StandardCharsets.UTF_8);
  }
}
