// SPDX-License-Identifier: GPL-3.0-or-later
// Files of balls, opened and saved as MeshLab does it.
#include "host.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QPluginLoader>
#include <QTemporaryDir>

#include <stdexcept>

#if VBM_MESHLAB_GENERATION == 2020
using Plugin = MeshIOInterface;
#else
#include <common/plugins/interfaces/io_plugin.h>
using Plugin = IOPlugin;
#endif

namespace {

Plugin &plugin() {
  static QPluginLoader loader(VBM_IO_PLUGIN);
  Plugin *loaded = qobject_cast<Plugin *>(loader.instance());
  if (!loaded) throw std::runtime_error(loader.errorString().toStdString());
  return *loaded;
}

// What went wrong, or "".
std::string open(const QString &path, MeshModel &layer, int &mask) {
  const QString format = path.section('.', -1).toUpper();
#if VBM_MESHLAB_GENERATION == 2020
  if (plugin().open(format, path, layer, mask, RichParameterList())) return "";
  return plugin().errorMsg().toStdString();
#else
  try {
    plugin().open(format, path, layer, mask, RichParameterList());
    return "";
  } catch (const MLException &error) {
    return error.what();
  }
#endif
}

std::string save(const QString &path, MeshModel &layer) {
  const QString format = path.section('.', -1).toUpper();
#if VBM_MESHLAB_GENERATION == 2020
  if (plugin().save(format, path, layer, 0, RichParameterList())) return "";
  return plugin().errorMsg().toStdString();
#else
  try {
    plugin().save(format, path, layer, 0, RichParameterList());
    return "";
  } catch (const MLException &error) {
    return error.what();
  }
#endif
}

void write(const QString &path, const char *text) {
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(text);
}

std::string content(const QString &path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : "not there";
}

TEST(BallFiles, AreOpenedAndSaved) {
  QTemporaryDir folder;
  const QString name = folder.filePath(QString::fromUtf8("b\u00e4lle.csv"));
  write(name, "0.1,0,0,1\n1,2,3,0.5\n");
  MeshDocument document;
  MeshModel *layer = host::add_layer(document, "balls");
  int mask = 0;
  ASSERT_EQ(open(name, *layer, mask), "");
  EXPECT_TRUE(mask & vcg::tri::io::Mask::IOM_VERTRADIUS);
  EXPECT_FALSE(mask & vcg::tri::io::Mask::IOM_FACEINDEX);
  ASSERT_EQ(layer->cm.VN(), 2);
  ASSERT_TRUE(layer->hasDataMask(MeshModel::MM_VERTRADIUS | MeshModel::MM_VERTQUALITY));
  EXPECT_EQ(layer->cm.vert[1].cP(), Point3m(1, 2, 3));
  EXPECT_EQ(layer->cm.vert[1].cR(), Scalarm(0.5));
  EXPECT_EQ(layer->cm.bbox.max, Point3m(1, 2, 3));

  const QString saved = folder.filePath("out.csv");
  ASSERT_EQ(save(saved, *layer), "");
  EXPECT_EQ(content(saved), "x,y,z,radius\n0.1,0,0,1\n1,2,3,0.5\n");
  const QString robot = folder.filePath("out.urdf");
  ASSERT_EQ(save(robot, *layer), "");
  EXPECT_NE(content(robot).find("radius=\"0.5\""), std::string::npos) << content(robot);
}

TEST(BallFiles, OfMedialMeshesHaveFaces) {
  QTemporaryDir folder;
  const QString name = folder.filePath("mesh.ma");
  write(name,
        "4 4 1\nv 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nv 0 0 1 2\ne 0 1\ne 1 2\ne 0 2\ne 2 3\nf 0 1 2\n");
  MeshDocument document;
  MeshModel *layer = host::add_layer(document, "mesh");
  int mask = 0;
  GLLogStream log;
#if VBM_MESHLAB_GENERATION == 2020
  plugin().setLog(&log);
#endif
  ASSERT_EQ(open(name, *layer, mask), "");
#if VBM_MESHLAB_GENERATION == 2020
  plugin().setLog(nullptr);
  ASSERT_EQ(log.logStringList().size(), 1);
  const std::string said = log.logStringList().front().second.toStdString();
#else
  const std::string said = plugin().warningMessageString().toStdString();
#endif
  EXPECT_NE(said.find("1 edge of no face is left out"), std::string::npos) << said;
  EXPECT_TRUE(mask & vcg::tri::io::Mask::IOM_FACEINDEX);
  EXPECT_EQ(layer->cm.FN(), 1);
  EXPECT_EQ(layer->cm.VN(), 4);
  const QString saved = folder.filePath("out.ma");
  ASSERT_EQ(save(saved, *layer), "");
  EXPECT_EQ(content(saved),
            "4 3 1\nv 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nv 0 0 1 2\ne 0 1\ne 0 2\ne 1 2\nf 0 1 2\n");
}

TEST(BallFiles, SayWhatIsWrong) {
  QTemporaryDir folder;
  MeshDocument document;
  MeshModel *layer = host::add_layer(document, "balls");
  int mask = 0;
  EXPECT_NE(open(folder.filePath("none.csv"), *layer, mask), "");
  const QString bad = folder.filePath("bad.csv");
  write(bad, "0,0,0,1\n0,0,0,-1\n");
  const std::string error = open(bad, *layer, mask);
  EXPECT_NE(error.find("line 2"), std::string::npos) << error;
  EXPECT_NE(error.find("bad.csv"), std::string::npos) << error;
  EXPECT_EQ(layer->cm.VN(), 0);
  write(bad, "x,y,z,radius\n");
  EXPECT_EQ(open(bad, *layer, mask), "This file holds no balls.");
  if (sizeof(Scalarm) == 4) {
    write(bad, "0,0,0,1\n1e300,0,0,1\n");
    const std::string beyond = open(bad, *layer, mask);
    EXPECT_NE(beyond.find("Ball 1"), std::string::npos) << beyond;
    EXPECT_EQ(layer->cm.VN(), 0);
  }
  // Without radii there are no balls to save, and no half of a file.
  vcg::tri::Allocator<CMeshO>::AddVertices(layer->cm, 3);
  const QString name = folder.filePath("out.csv");
  EXPECT_NE(save(name, *layer).find("have no radius"), std::string::npos);
  EXPECT_EQ(content(name), "not there");
}

} // namespace
